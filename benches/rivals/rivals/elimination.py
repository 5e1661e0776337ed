"""Symbolic solvers of `J x = b` for CasADi's SX, so that its best can be looked for."""

import casadi as ca
import numpy as np

PIVOT_THRESHOLD = 0.1


def builtin(matrix):
    """CasADi's own: block triangular order, dense QR of the blocks."""
    return lambda b: ca.solve(matrix, b)


def sparse_qr(matrix):
    """Sparse QR with approximate minimum degree."""
    factors = ca.qr_sparse(matrix, True)
    return lambda b: ca.qr_solve(b, *factors)


def sparse_qr_as_is(matrix):
    """Sparse QR, columns in the order of the listing."""
    factors = ca.qr_sparse(matrix, False)
    return lambda b: ca.qr_solve(b, *factors)


def normal_equations(matrix):
    """Sparse LDL of `J^T J`."""
    factors = ca.ldl(matrix.T @ matrix, True)
    return lambda b: ca.ldl_solve(matrix.T @ b, *factors)


def minimum_norm(matrix):
    """Sparse LDL of `J J^T`."""
    factors = ca.ldl(matrix @ matrix.T, True)
    return lambda b: matrix.T @ ca.ldl_solve(b, *factors)


def written_lu(samples):
    """LU without pivoting, in an order that suits the sampled Jacobians; not part of CasADi."""
    order = pivot_order(samples)
    return lambda matrix: _eliminate(matrix, order)


def _eliminate(matrix, order):
    work = {(i, j): matrix[i, j] for i, j in zip(*matrix.sparsity().get_triplet())}
    lower = []
    for step, (row, column) in enumerate(order):
        pivot = 1 / work[row, column]
        later_columns = [c for _, c in order[step + 1 :] if (row, c) in work]
        for other, _ in order[step + 1 :]:
            if (other, column) in work:
                factor = work[other, column] * pivot
                lower.append((other, row, factor))
                for c in later_columns:
                    work[other, c] = work.get((other, c), 0) - factor * work[row, c]
        work[row, column] = pivot
    return lambda b: _substitute(order, lower, work, b)


def _substitute(order, lower, work, b):
    right = [b[i] for i in range(len(order))]
    for other, row, factor in lower:
        right[other] = right[other] - factor * right[row]
    x = [None] * len(order)
    for step in reversed(range(len(order))):
        row, column = order[step]
        known = sum((work[row, c] * x[c] for _, c in order[step + 1 :] if (row, c) in work), 0)
        x[column] = (right[row] - known) * work[row, column]
    return ca.vertcat(*x)


def pivot_order(samples):
    """Markowitz's greedy order whose pivots stay above a part of their column in all samples."""
    work = np.array(samples)
    filled = (work != 0).any(axis=0)
    rows, columns, order = list(range(filled.shape[0])), list(range(filled.shape[1])), []
    while rows:
        row, column = min(
            ((i, j) for i in rows for j in columns if filled[i, j]),
            key=lambda at: _rank(work, filled, rows, columns, *at),
        )
        order.append((row, column))
        rows.remove(row)
        columns.remove(column)
        factors = work[:, rows, column] / work[:, row, column][:, None]
        block = np.ix_(range(len(work)), rows, columns)
        work[block] -= factors[:, :, None] * work[:, row, columns][:, None, :]
        filled[np.ix_(rows, columns)] |= np.outer(filled[rows, column], filled[row, columns])
    return order


def _rank(work, filled, rows, columns, i, j):
    health = (abs(work[:, i, j]) / abs(work[:, rows, j]).max(axis=1)).min()
    fill = (filled[rows, j].sum() - 1) * (filled[i, columns].sum() - 1)
    return health < PIVOT_THRESHOLD, fill, -health


SOLVERS = {
    "solve": builtin,
    "qr_sparse": sparse_qr,
    "qr_sparse unordered": sparse_qr_as_is,
    "ldl of J'J": normal_equations,
    "ldl of JJ'": minimum_norm,
}
