//! The reasons for which the program ends early, and its exit codes.

use std::fmt;
use std::io;

/// The reason for which the program ends early. Each kind has its own exit code.
#[derive(Debug)]
pub enum Failure {
    /// A result could not be written: exit code 1.
    Output(String),
    /// The input is wrong; the message names the place: exit code 2.
    Input(String),
    /// The solver found no configuration: exit code 3.
    Solver(String),
    /// The user asked to stop: exit code 130.
    Interrupted(String),
    /// The reader of standard output has closed it, so there is nothing to report: exit code 0.
    ReaderGone,
}

/// The most mistakes that are reported at once.
pub(crate) const MOST_MISTAKES: usize = 20;

impl Failure {
    /// Returns all values, or one failure with the mistakes of all wrong inputs, at most twenty; a failure of another kind is returned
    /// alone.
    ///
    /// # Errors
    ///
    /// If a result is a failure.
    pub fn all<T>(results: impl IntoIterator<Item = Result<T, Self>>) -> Result<Vec<T>, Self> {
        let mut values = Vec::new();
        let mut mistakes = Vec::new();
        for result in results {
            match result {
                Ok(value) => values.push(value),
                Err(Self::Input(mistake)) => mistakes.push(mistake),
                Err(other) => return Err(other),
            }
            if mistakes.len() == MOST_MISTAKES {
                break;
            }
        }
        if mistakes.is_empty() {
            Ok(values)
        } else {
            Err(Self::Input(mistakes.join("\n")))
        }
    }

    /// Returns both values, or the mistakes of both if both are wrong inputs.
    ///
    /// # Errors
    ///
    /// If one of them is a failure.
    pub fn both<A, B>(first: Result<A, Self>, second: Result<B, Self>) -> Result<(A, B), Self> {
        match (first, second) {
            (Ok(first), Ok(second)) => Ok((first, second)),
            (Err(Self::Input(first)), Err(Self::Input(second))) => {
                Err(Self::Input(format!("{first}\n{second}")))
            }
            (Err(failure), _) | (_, Err(failure)) => Err(failure),
        }
    }

    /// Returns the exit code of the process.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::ReaderGone => 0,
            Self::Output(_) => 1,
            Self::Input(_) => 2,
            Self::Solver(_) => 3,
            Self::Interrupted(_) => 130,
        }
    }

    /// Makes the failure of a wrong input that concerns the file `file`, without a place in it.
    pub fn input(file: &str, message: impl fmt::Display) -> Self {
        Self::Input(format!("{file}: {message}"))
    }

    /// Makes the failure of an interrupt before a result at `place`, or of a file called so, was written.
    pub fn nothing_written(place: impl fmt::Display) -> Self {
        Self::Interrupted(format!("{place}: interrupted; nothing was written"))
    }

    /// Makes the failure to write to `place`.
    pub fn writing(place: impl fmt::Display, error: &io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::ReaderGone,
            io::ErrorKind::Interrupted => Self::nothing_written(place),
            _ => Self::Output(format!("{place}: cannot be written: {error}")),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Output(text)
            | Self::Input(text)
            | Self::Solver(text)
            | Self::Interrupted(text) => f.write_str(text),
            Self::ReaderGone => f.write_str("nobody reads standard output"),
        }
    }
}

impl std::error::Error for Failure {}
