//! Every function of listings from text with wrong arguments: they are refused, and nothing changes.
#![allow(unsafe_code, reason = "it takes what C would pass")]

mod text;

use suspension_c::listing::{self, Corner};
use suspension_c::{Destroy, In, InOut, Out, Status};
use text::{POINT, from, made, placed, pushrod, to};

#[test]
fn wrong_objects_are_refused_with_their_status() {
    let (listing, mut corner) = (pushrod(), placed());
    // SAFETY: null, misaligned, or to an object of another kind, which the function refuses.
    let wrong = unsafe {
        [
            (In::from_raw(std::ptr::null()), Status::Null),
            (
                In::from_raw(listing.0.cast::<u8>().wrapping_add(1).cast()),
                Status::Misaligned,
            ),
            (In::from_raw(corner.0.cast_const().cast()), Status::Object),
        ]
    };
    for (wrong, expected) in wrong {
        assert_eq!(
            made(|count| listing::listing_count(wrong, POINT, count)),
            Err(expected)
        );
        assert!(listing::listing_name(wrong, POINT, 0).as_ptr().is_null());
        let points = listing.design();
        let made = made(|corner| {
            listing::corner_new(wrong, from(&points), points.len(), corner, None.into())
        });
        assert_eq!(made.map(|_: *mut Corner| ()), Err(expected));
    }
    let drives = [0.0; 6];
    let mut measures = [0.0; 6];
    // SAFETY: as above.
    let wrong = unsafe {
        [
            InOut::from_raw(std::ptr::null_mut()),
            InOut::from_raw(listing.0.cast()),
        ]
    };
    for (wrong, expected) in wrong.into_iter().zip([Status::Null, Status::Object]) {
        let none = None.into();
        let status = listing::corner_step(wrong, from(&drives), 6, 0.1, none, None.into());
        assert_eq!(status, expected);
    }
    // SAFETY: as above.
    unsafe {
        assert_eq!(
            listing::listing_destroy(Destroy::from_raw(std::ptr::null_mut())),
            Status::Ok
        );
        assert_eq!(
            listing::corner_destroy(Destroy::from_raw(std::ptr::null_mut())),
            Status::Ok
        );
        assert_eq!(
            listing::corner_destroy(Destroy::from_raw(listing.0.cast())),
            Status::Object
        );
        assert_eq!(
            listing::listing_destroy(Destroy::from_raw(corner.0.cast())),
            Status::Object
        );
        let nothing = Out::from_raw(std::ptr::null_mut());
        assert_eq!(
            listing::corner_read_measures(corner.get(), nothing, 6),
            Status::Null
        );
        let nothing = In::from_raw(std::ptr::null());
        let status =
            listing::corner_step(corner.get_mut(), nothing, 6, 0.1, None.into(), None.into());
        assert_eq!(status, Status::Null);
    }
    assert_eq!(
        listing::corner_read_measures(corner.get(), to(&mut measures), 6),
        Status::Ok
    );
}

#[test]
fn wrong_counts_and_numbers_are_refused_and_change_no_output() {
    let (listing, mut corner) = (pushrod(), placed());
    let mut numbers = [7.0; 200];
    for count in [0, 1, 200] {
        let get = |numbers: &mut [f64; 200], call: &dyn Fn(Out<'_, f64>) -> Status| {
            assert_eq!(call(to(numbers)), Status::Size, "{count}");
            assert_eq!(numbers, &[7.0; 200]);
        };
        get(&mut numbers, &|place| {
            listing::listing_design(listing.get(), place, count)
        });
        get(&mut numbers, &|place| {
            listing::corner_drives(corner.get(), place, count)
        });
        get(&mut numbers, &|place| {
            listing::corner_read_points(corner.get(), place, count)
        });
        get(&mut numbers, &|place| {
            listing::corner_read_measures(corner.get(), place, count)
        });
        get(&mut numbers, &|place| {
            let (corner, change, none) = (corner.get(), [1.0, 0.0], None.into());
            listing::corner_read_derivatives(
                corner,
                from(&change),
                2,
                place,
                count,
                None.into(),
                0,
                none,
            )
        });
        get(&mut numbers, &|place| {
            let (corner, change, none) = (corner.get(), [1.0; 200], None.into());
            listing::corner_read_derivatives(
                corner,
                from(&change),
                count,
                None.into(),
                0,
                place,
                6,
                none,
            )
        });
        get(&mut numbers, &|place| {
            listing::corner_read_state(corner.get(), place, count)
        });
        assert_eq!(corner.set_state(&vec![0.3; count]), Status::Size);
        let drives = [0.3; 200];
        let status = listing::corner_step(
            corner.get_mut(),
            from(&drives),
            count,
            0.1,
            None.into(),
            None.into(),
        );
        assert_eq!(status, Status::Size);
    }
    let before = corner.drives();
    assert!(corner.step([f64::NAN; 2], false).is_err());
    assert!(corner.step([f64::INFINITY; 2], true).is_err());
    let mut state = corner.state();
    state[7] = f64::NAN;
    assert_eq!(corner.set_state(&state), Status::Argument);
    assert_eq!((corner.drives(), corner.time()), (before, 0.0));
    let (change, mut measures) = ([1.0, f64::NAN], [7.0; 6]);
    let place = to(&mut measures);
    let status = listing::corner_read_derivatives(
        corner.get(),
        from(&change),
        2,
        None.into(),
        0,
        place,
        6,
        None.into(),
    );
    assert_eq!((status, measures), (Status::NotFinite, [7.0; 6]));
}
