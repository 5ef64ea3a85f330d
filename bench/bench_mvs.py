"""Multi-view stereo beside the straightforward OpenCV form of eq. 3, in one run.

The peer shifts each view with cubic ``cv2.warpAffine``, takes each view's window mean and deviation once per height,
and correlates all pairs with ``cv2.blur``, on as many threads as the kernels; its time for the whole search is measured
over some of the heights and multiplied.  Joint matching is timed whole: four groups of lights, preparation and
quality included.  Processor time stands beside wall time, because other work on the machine lengthens the latter.
Accuracy: the same scenes over the whole search, each method with its default settings; the peer and the
exact search see the mean over the lights, which is the better picture here.

    python -m bench.bench_mvs [--shape 1038 1388] [--views 12] [--heights 30]
"""

from __future__ import annotations

import argparse
import multiprocessing
import resource
import sys
import time
from itertools import combinations
from typing import Any

import cv2
import numba
import numpy as np
from numpy.typing import NDArray
from tests.reconstruction import scenes

from reliefscope.axes import apparent_shift_px
from reliefscope.reconstruction.joint import GROUPS, match_jointly
from reliefscope.reconstruction.mvs import WINDOW, match_views, mean_ncc

PIXEL_UM = 1.12
SEARCH_UM = np.arange(0.0, 150.0)
"""Range and step of the paper's kind of search."""
APERTURE_BLUR_UM = 2.5
"""Standard deviation of the Gaussian nearest to the Airy disc of a 1.5 mm aperture (eq. 2)."""
ACCURACY_SHAPE = (160, 208)


def opencv_mean_ncc(
    views: NDArray[np.float32], slopes: NDArray[np.float64], height_um: float
) -> NDArray[np.float32]:
    """Mean of eq. 3 over all pairs, pair by pair, with OpenCV's filters."""
    size = (views.shape[2], views.shape[1])
    shifted, means, deviations = [], [], []
    for view, (sx, sy) in zip(views, slopes, strict=True):
        cols, rows = apparent_shift_px(height_um, (sx, sy), PIXEL_UM)
        move = np.array([[1, 0, cols], [0, 1, rows]])
        flags = cv2.INTER_CUBIC | cv2.WARP_INVERSE_MAP
        image = cv2.warpAffine(view, move, size, flags=flags, borderMode=cv2.BORDER_REPLICATE)
        mean = cv2.blur(image, (WINDOW, WINDOW))
        square = cv2.blur(image * image, (WINDOW, WINDOW))
        shifted.append(image)
        means.append(mean)
        deviations.append(np.sqrt(np.maximum(square - mean * mean, 1e-12)))
    total = np.zeros(views.shape[1:], dtype=np.float32)
    pairs = list(combinations(range(len(views)), 2))
    for i, j in pairs:
        product = cv2.blur(cv2.multiply(shifted[i], shifted[j]), (WINDOW, WINDOW))
        total += (product - means[i] * means[j]) / (deviations[i] * deviations[j])
    return np.asarray(np.clip(total / len(pairs), -1, 1), dtype=np.float32)


def opencv_height(views: NDArray[np.float32], slopes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Height of the greatest score over the whole search, as the paper takes it."""
    curves = np.stack([opencv_mean_ncc(views, slopes, float(z)) for z in SEARCH_UM])
    return np.asarray(SEARCH_UM[np.argmax(curves, axis=0)])


def full_size(
    shape: tuple[int, int], views: int
) -> tuple[NDArray[np.float32], NDArray[np.float64]]:
    """Textured terraces as channels (groups of lights, views, H, W), and slopes.

    A floor and, on a third of the field, tops 40 um above it, all as blurred as the benchtop's apertures blur:
    matching bins them and looks behind their steps as it does with frames.
    """
    slopes = scenes.hexagon_slopes(views, 0.127)
    margin = 16
    wide = (shape[0] + 2 * margin, shape[1] + 2 * margin)
    rng = np.random.default_rng(1)
    columns, rows = np.meshgrid(np.arange(wide[1]), np.arange(wide[0]))
    raised = ((columns // 60 % 3 == 0) & (rows // 60 % 3 != 2)).astype(np.float32)
    images = np.empty((GROUPS, views, *shape), dtype=np.float32)
    for channel in images:
        top, floor = (
            sum(
                cv2.GaussianBlur(rng.random(wide, dtype=np.float32), (0, 0), scale) * scale
                for scale in (APERTURE_BLUR_UM / PIXEL_UM, 6.0, 20.0)
            )
            for _ in range(2)
        )
        for view, (sx, sy) in zip(channel, slopes, strict=True):
            cols, down = apparent_shift_px(40.0, (sx, sy), PIXEL_UM)
            move = np.array([[1, 0, cols], [0, 1, down]])
            seen, high = (cv2.warpAffine(image, move, wide[::-1]) for image in (top, raised))
            mixed = cv2.GaussianBlur(
                seen * high + floor * (1 - high), (0, 0), APERTURE_BLUR_UM / PIXEL_UM
            )
            view[...] = mixed[margin:-margin, margin:-margin]
    return images, slopes


def joint_peak_mb(shape: tuple[int, int], views: int) -> float:
    """Peak memory of a fresh process that matches jointly, its input included."""
    context = multiprocessing.get_context("spawn")
    with context.Pool(1) as pool:
        return pool.apply(_joint_process, (shape, views))


def _joint_process(shape: tuple[int, int], views: int) -> float:
    channels, slopes = full_size(shape, views)
    match_jointly(channels, slopes, (SEARCH_UM[0], SEARCH_UM[-1]), PIXEL_UM)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (1e6 if sys.platform == "darwin" else 1e3)


def accuracy(views: int) -> dict[str, float]:
    """Mean absolute errors (um) over a dome and a slanted plane, without any alignment."""
    slopes = scenes.hexagon_slopes(views, 0.127)
    inside = np.s_[20:-20, 20:-20]
    errors: dict[str, list[float]] = {}
    for height in (scenes.dome(ACCURACY_SHAPE, 45, 60.0), scenes.plane(0.1, 0.2, 40.0)):
        scene = scenes.render(height, ACCURACY_SHAPE, slopes, noise=0.005)
        found: dict[str, NDArray[np.floating[Any]]] = {
            "mvs_mae_um": match_jointly(
                scene.views, slopes, (SEARCH_UM[0], SEARCH_UM[-1]), PIXEL_UM
            ).height_um,
            "mvs_opencv_mae_um": opencv_height(scene.views, slopes),
            "mvs_paper_mae_um": match_views(scene.views, slopes, SEARCH_UM, PIXEL_UM).height_um,
            "mvs_sum_double_step_mae_um": match_views(
                scene.views,
                slopes,
                SEARCH_UM[::2],
                PIXEL_UM,
                parabola=True,
                form="variance_of_sum",
            ).height_um,
        }
        for name, map_um in found.items():
            error = np.abs(map_um - scene.height_um)[inside]
            errors.setdefault(name, []).append(float(np.nanmean(error)))
    return {name: float(np.mean(values)) for name, values in errors.items()}


def run(
    shape: tuple[int, int] = (1038, 1388), views: int = 12, heights: int = 30
) -> dict[str, float]:
    """Figures of matching: time and memory of the whole search, ratios, errors."""
    cv2.setNumThreads(numba.get_num_threads())
    channels, slopes = full_size(shape, views)
    images = channels[0]
    span = (float(SEARCH_UM[0]), float(SEARCH_UM[-1]))
    match_jointly(channels[:, :, :160, :160], slopes, (0.0, 20.0), PIXEL_UM)  # compile
    joint_s, joint_cpu_s = np.inf, np.inf
    for _ in range(3):
        started, cpu = time.perf_counter(), time.process_time()
        match_jointly(channels, slopes, span, PIXEL_UM)
        joint_s = min(joint_s, time.perf_counter() - started)
        joint_cpu_s = min(joint_cpu_s, time.process_time() - cpu)
    few = np.linspace(10.0, 140.0, max(3, heights // 5))
    opencv_mean_ncc(images, slopes, 5.0)  # warm up
    opencv_s, opencv_cpu_s = np.inf, np.inf
    for z in few:
        started, cpu = time.perf_counter(), time.process_time()
        opencv_mean_ncc(images, slopes, float(z))
        opencv_s = min(opencv_s, time.perf_counter() - started)
        opencv_cpu_s = min(opencv_cpu_s, time.process_time() - cpu)

    mean_ncc(images[:, :64, :64], slopes, 10.0, PIXEL_UM)  # compile
    timed = np.linspace(10.0, 140.0, heights)
    started = time.perf_counter()
    match_views(images, slopes, timed, PIXEL_UM)
    kernel_s = (time.perf_counter() - started) / heights
    match_views(images[:, :64, :64], slopes, timed[:3], PIXEL_UM, form="variance_of_sum")  # compile
    started = time.perf_counter()
    match_views(images, slopes, timed, PIXEL_UM, form="variance_of_sum")
    by_sum_s = (time.perf_counter() - started) / heights
    return {
        "mvs_s": joint_s,
        "mvs_cpu_s": joint_cpu_s,
        "mvs_opencv_s": opencv_s * SEARCH_UM.size,
        "mvs_opencv_cpu_s": opencv_cpu_s * SEARCH_UM.size,
        "mvs_ratio": opencv_s * SEARCH_UM.size / joint_s,
        "mvs_cpu_ratio": opencv_cpu_s * SEARCH_UM.size / joint_cpu_s,
        "mvs_megapixels_per_s": shape[0] * shape[1] / joint_s / 1e6,
        "mvs_peak_mb": joint_peak_mb(shape, views),
        "mvs_paper_s_per_height": kernel_s,
        "mvs_opencv_s_per_height": opencv_s,
        "mvs_paper_ratio": opencv_s / kernel_s,
        "mvs_sum_s_per_height": by_sum_s,
        "mvs_sum_ratio": opencv_s / by_sum_s,
        **accuracy(views),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--shape", type=int, nargs=2, default=(1038, 1388), metavar=("H", "W"))
    parser.add_argument("--views", type=int, default=12)
    parser.add_argument("--heights", type=int, default=30)
    options = parser.parse_args()
    for name, value in run(tuple(options.shape), options.views, options.heights).items():
        print(f"{name:32s} {value:10.4g}")


if __name__ == "__main__":
    main()
