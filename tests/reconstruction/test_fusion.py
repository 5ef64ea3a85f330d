import numpy as np
import pytest
from scipy import sparse
from scipy.sparse.linalg import spsolve

from reliefscope import axes
from reliefscope.errors import Cancelled, InvalidInputError
from reliefscope.jobs import Job
from reliefscope.reconstruction import fusion

PIXEL_UM = 1.12
SOBEL_X = np.array([[-1, 0, 1], [-2, 0, 2], [-1, 0, 1]]) / 8
SOBEL_Y = np.array([[1, 2, 1], [0, 0, 0], [-1, -2, -1]]) / 8


def stencil_matrix(shape: tuple[int, int], taps: dict[tuple[int, int], float]) -> sparse.csr_array:
    """Rows of pixels whose whole stencil lies in the image; other rows are empty."""
    height, width = shape
    index = np.arange(height * width).reshape(shape)
    inside = np.ones(shape, bool)
    for dy, dx in taps:
        for axis, (step, size) in enumerate(((dy, height), (dx, width))):
            place = np.arange(size) + step
            ok = (place >= 0) & (place < size)
            inside &= ok[:, None] if axis == 0 else ok[None, :]
    rows = index[inside]
    matrix = sparse.csr_array((index.size, index.size))
    for (dy, dx), value in taps.items():
        columns = rows + dy * width + dx
        matrix += sparse.csr_array((np.full(rows.size, value), (rows, columns)), shape=matrix.shape)
    return matrix


def kernel_taps(kernel: np.ndarray) -> dict[tuple[int, int], float]:
    return {(i - 1, j - 1): kernel[i, j] for i in range(3) for j in range(3) if kernel[i, j]}


def random_problem(shape: tuple[int, int], seed: int) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(seed)
    normals = np.concatenate([rng.normal(0, 0.3, (*shape, 2)), np.ones((*shape, 1))], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    q_ps = rng.uniform(0.25, 1.0, shape)
    q_ps[rng.random(shape) < 0.15] = 0.0
    q_mvs = rng.uniform(0.25, 1.0, shape)
    q_mvs[shape[0] // 3 : 2 * shape[0] // 3, 4:14] = 0.0
    return {
        "height_um": rng.normal(0, 5, shape),
        "q_mvs": q_mvs,
        "normals": normals,
        "q_ps": q_ps,
    }


def reference(problem: dict[str, np.ndarray], derivative: str, minimum: float) -> np.ndarray:
    """Eq. 13 written out as a sparse matrix, solved directly."""
    shape = problem["height_um"].shape
    size = problem["height_um"].size
    slopes = [
        (-problem["normals"][..., axis] / problem["normals"][..., 2]).ravel() for axis in (0, 1)
    ]
    q = problem["q_ps"].copy()
    weight_mvs = 0.05 * np.maximum(problem["q_mvs"], minimum).ravel()
    blocks = [sparse.diags_array(weight_mvs)]
    values = [weight_mvs * problem["height_um"].ravel()]

    def add(matrix: sparse.csr_array, quality: np.ndarray, slope: np.ndarray) -> None:
        quality = quality * (abs(matrix).sum(axis=1) > 0)
        blocks.append(sparse.diags_array(quality) @ matrix / PIXEL_UM)
        values.append(quality * slope)

    if derivative == "forward":
        for axis, ahead in ((0, (0, 1)), (1, (-1, 0))):
            behind = (-ahead[0], -ahead[1])
            for taps in ({ahead: 1.0, (0, 0): -1.0}, {(0, 0): 1.0, behind: -1.0}):
                add(stencil_matrix(shape, taps), q.ravel() * np.sqrt(0.5), slopes[axis])
    else:
        for kernel, slope in ((SOBEL_X, slopes[0]), (SOBEL_Y, slopes[1])):
            add(stencil_matrix(shape, kernel_taps(kernel)), q.ravel(), slope)
    if derivative == "sobel_stabilised":
        q[[0, -1]] = 0.0
        q[:, [0, -1]] = 0.0
        for across, share in ((-1, 0.25), (0, 0.5), (1, 0.25)):
            for along in (0, 1):
                part = q.ravel() * np.sqrt(fusion.STABILISER * share * 0.5)
                x_taps = {(across, along): 1.0, (across, along - 1): -1.0}
                y_taps = {(-along, across): 1.0, (1 - along, across): -1.0}
                add(stencil_matrix(shape, x_taps), part, slopes[0])
                add(stencil_matrix(shape, y_taps), part, slopes[1])
    matrix = sparse.vstack(blocks).tocsr()
    assert matrix.shape[1] == size
    return spsolve((matrix.T @ matrix).tocsc(), matrix.T @ np.concatenate(values)).reshape(shape)


@pytest.mark.parametrize("derivative", ["sobel_stabilised", "sobel", "forward"])
def test_agrees_with_a_direct_sparse_solver(derivative: fusion.Derivative) -> None:
    problem = random_problem((23, 30), seed=1)
    minimum = 0.1
    expected = reference(problem, derivative, minimum)
    result = fusion.fuse(
        **problem,
        pixel_um=PIXEL_UM,
        derivative=derivative,
        minimum_quality=minimum,
        tolerance_um=1e-6,
        maximum_iterations=3000,
    )
    assert result.converged
    np.testing.assert_allclose(result.height_um, expected, atol=2e-4)


def plane_problem(shape: tuple[int, int], surface: np.ndarray) -> dict[str, np.ndarray]:
    return {
        "height_um": surface,
        "q_mvs": np.full(shape, 0.5),
        "normals": axes.normals_from_height(surface, PIXEL_UM),
        "q_ps": np.full(shape, 0.8),
    }


def test_literal_sobel_does_not_see_alternating_modes_and_the_default_does() -> None:
    """Chequerboard and stripes of 1 um in the heights: kept by eq. 13, flattened by the default."""
    shape = (32, 40)
    row, column = np.indices(shape)
    flat = plane_problem(shape, np.zeros(shape))
    for mode in ((-1.0) ** (row + column), (-1.0) ** column, (-1.0) ** row * np.sin(column / 7)):
        problem = flat | {"height_um": mode}
        literal = fusion.fuse(
            **problem, pixel_um=PIXEL_UM, derivative="sobel", tolerance_um=1e-4
        ).height_um
        default = fusion.fuse(**problem, pixel_um=PIXEL_UM, tolerance_um=1e-4).height_um
        inner = (slice(3, -3), slice(3, -3))
        np.testing.assert_allclose(literal[inner], mode[inner], atol=0.05)
        assert np.abs(default[inner]).max() < 0.03


def test_default_agrees_with_the_literal_form_on_smooth_data() -> None:
    shape = (40, 48)
    row, column = np.indices(shape)
    surface = 8 * np.sin(column / 9) * np.cos(row / 11)
    problem = plane_problem(shape, surface)
    problem["height_um"] = surface + 3 * np.sin(column / 13 + row / 17)
    literal = fusion.fuse(
        **problem,
        pixel_um=PIXEL_UM,
        derivative="sobel",
        tolerance_um=1e-4,
        maximum_iterations=3000,
    ).height_um
    default = fusion.fuse(**problem, pixel_um=PIXEL_UM, tolerance_um=1e-4).height_um
    difference = (default - literal)[3:-3, 3:-3]
    assert np.sqrt(np.mean(difference**2)) < 0.1
    assert np.abs(default - surface).mean() < 0.5 * np.abs(problem["height_um"] - surface).mean()


@pytest.mark.parametrize("derivative", ["sobel_stabilised", "forward"])
def test_slopes_span_a_hole_in_the_heights(derivative: fusion.Derivative) -> None:
    """Signs and the unit of T: a plane of 0.3 and -0.2 um/um is carried through a hole of garbage."""
    shape = (60, 70)
    x_um, y_um = axes.pixel_grid_um(shape, PIXEL_UM)
    surface = 0.3 * x_um[None, :] - 0.2 * y_um[:, None]
    problem = plane_problem(shape, surface)
    problem["height_um"] = surface.copy()
    problem["height_um"][20:40, 25:50] = np.nan
    result = fusion.fuse(**problem, pixel_um=PIXEL_UM, derivative=derivative)
    np.testing.assert_allclose(result.height_um, surface, atol=0.02)


@pytest.mark.parametrize("derivative", ["sobel_stabilised", "forward"])
def test_iterations_do_not_grow_with_size(derivative: fusion.Derivative) -> None:
    counts = []
    for shape in ((48, 64), (192, 256), (384, 512)):
        problem = random_problem(shape, seed=3)
        counts.append(fusion.fuse(**problem, pixel_um=PIXEL_UM, derivative=derivative).iterations)
    assert max(counts) <= min(counts) + 4
    assert max(counts) <= 30


@pytest.mark.parametrize("pixel_um", [0.01, 1.12, 100.0])
def test_work_and_shape_do_not_depend_on_the_size_of_a_pixel(pixel_um: float) -> None:
    """The same slopes under any unit of length: same iterations, heights in proportion."""
    problem = random_problem((96, 128), seed=7)
    normals, weights = problem["normals"], problem["q_ps"]
    expected = fusion.integrate(normals, weights, 1.0, tolerance_um=1e-5)
    result = fusion.integrate(normals, weights, pixel_um)
    assert result.converged
    assert result.iterations == fusion.integrate(normals, weights, 1.0).iterations
    assert result.error_um <= fusion.TOLERANCE_PX * pixel_um
    difference = result.height_um / pixel_um - expected.height_um
    assert np.sqrt(np.nanmean(difference**2)) < fusion.TOLERANCE_PX


def test_threads_are_given_back() -> None:
    import numba

    before = numba.get_num_threads()
    fusion.fuse(**random_problem((20, 24), seed=8), pixel_um=PIXEL_UM)
    assert numba.get_num_threads() == before


def test_a_pixel_that_nothing_holds_is_missing() -> None:
    problem = plane_problem((20, 24), np.zeros((20, 24)))
    problem["height_um"] = np.zeros((20, 24))
    problem["height_um"][:8, :8] = np.nan
    problem["q_ps"][:8, :8] = 0.0
    result = fusion.fuse(**problem, pixel_um=PIXEL_UM)
    assert np.isnan(result.height_um[:6, :6]).all()
    assert np.isfinite(result.height_um[9:, 9:]).all()


def test_integration_of_a_hemisphere() -> None:
    shape = (81, 81)
    x_um, y_um = axes.pixel_grid_um(shape, PIXEL_UM)
    square = x_um[None, :] ** 2 + y_um[:, None] ** 2
    radius = 70.0
    surface = np.sqrt(radius**2 - square)
    normals = np.stack(
        [
            np.broadcast_to(x_um[None, :], shape) / radius,
            np.broadcast_to(y_um[:, None], shape) / radius,
            surface / radius,
        ],
        axis=-1,
    )
    for derivative in ("sobel_stabilised", "forward"):
        result = fusion.integrate(normals, np.ones(shape), PIXEL_UM, derivative=derivative)
        assert result.converged
        assert float(result.height_um.mean()) == pytest.approx(0.0, abs=1e-4)
        np.testing.assert_allclose(result.height_um, surface - surface.mean(), atol=0.15)


def test_result_does_not_depend_on_threads() -> None:
    import numba

    problem = random_problem((64, 72), seed=5)
    whole = fusion.fuse(**problem, pixel_um=PIXEL_UM).height_um
    before = numba.get_num_threads()
    try:
        numba.set_num_threads(1)
        single = fusion.fuse(**problem, pixel_um=PIXEL_UM).height_um
    finally:
        numba.set_num_threads(before)
    np.testing.assert_allclose(single, whole, atol=1e-6)


def test_bad_input_is_refused() -> None:
    problem = plane_problem((20, 24), np.zeros((20, 24)))
    with pytest.raises(InvalidInputError, match="does not belong"):
        fusion.fuse(**(problem | {"q_mvs": np.ones((20, 23))}), pixel_um=1.0)
    with pytest.raises(InvalidInputError, match="negative or undefined"):
        fusion.fuse(**(problem | {"q_ps": np.full((20, 24), np.nan)}), pixel_um=1.0)
    with pytest.raises(InvalidInputError, match="nothing to make a surface"):
        fusion.integrate(problem["normals"], np.zeros((20, 24)), 1.0)


def test_cancelling_stops_the_solver() -> None:
    job = Job()
    job.cancel()
    with pytest.raises(Cancelled):
        fusion.fuse(**random_problem((20, 24), seed=6), pixel_um=PIXEL_UM, job=job)
