"""Multi-view stereo beside the straightforward OpenCV form of eq. 3, in one run.

The peer shifts each view with cubic ``cv2.warpAffine``, takes each view's window
mean and deviation once per height, and correlates all pairs with ``cv2.blur``, on as many threads as the kernel.
Speed is measured at full size over some of the heights, accuracy on a smaller scene over the whole search.

    python -m bench.bench_mvs [--shape 1038 1388] [--views 12] [--heights 30]
"""

from __future__ import annotations

import argparse
import resource
import sys
import time
from itertools import combinations

import cv2
import numba
import numpy as np
from numpy.typing import NDArray
from tests.reconstruction import scenes

from reliefscope.axes import apparent_shift_px
from reliefscope.reconstruction.mvs import WINDOW, match_views, mean_ncc

PIXEL_UM = 1.12
SEARCH_UM = np.arange(0.0, 150.0)
"""Range and step of the paper's kind of search."""
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


def run(
    shape: tuple[int, int] = (1038, 1388), views: int = 12, heights: int = 30
) -> dict[str, float]:
    """Figures of matching: seconds per height of both, their ratio, errors on one scene."""
    cv2.setNumThreads(numba.get_num_threads())
    slopes = scenes.hexagon_slopes(views, 0.127)
    random = np.random.default_rng(1)
    images = random.random((views, *shape), dtype=np.float32)
    mean_ncc(images[:, :64, :64], slopes, 10.0, PIXEL_UM)  # compile
    timed = np.linspace(10.0, 140.0, heights)
    started = time.perf_counter()
    match_views(images, slopes, timed, PIXEL_UM)
    kernel_s = (time.perf_counter() - started) / heights
    match_views(images[:, :64, :64], slopes, timed[:3], PIXEL_UM, form="variance_of_sum")  # compile
    started = time.perf_counter()
    match_views(images, slopes, timed, PIXEL_UM, form="variance_of_sum")
    by_sum_s = (time.perf_counter() - started) / heights
    started = time.perf_counter()
    few = timed[:: max(1, heights // 5)]
    for z in few:
        opencv_mean_ncc(images, slopes, float(z))
    opencv_s = (time.perf_counter() - started) / few.size

    scene = scenes.render(
        scenes.dome(ACCURACY_SHAPE, 45, 60.0), ACCURACY_SHAPE, slopes, noise=0.005
    )
    inside = np.s_[20:-20, 20:-20]
    ours = match_views(scene.views, slopes, SEARCH_UM, PIXEL_UM).height_um
    by_sum = match_views(
        scene.views, slopes, SEARCH_UM[::2], PIXEL_UM, parabola=True, form="variance_of_sum"
    ).height_um
    theirs = opencv_height(scene.views, slopes)
    peak_kb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return {
        "mvs_paper_s_per_height": kernel_s,
        "mvs_opencv_s_per_height": opencv_s,
        "mvs_paper_ratio": opencv_s / kernel_s,
        "mvs_paper_megapixels_per_s": shape[0] * shape[1] / kernel_s / 1e6,
        "mvs_sum_s_per_height": by_sum_s,
        "mvs_sum_ratio": opencv_s / by_sum_s,
        "mvs_sum_double_step_mae_um": float(np.nanmean(np.abs(by_sum - scene.height_um)[inside])),
        "mvs_paper_mae_um": float(np.nanmean(np.abs(ours - scene.height_um)[inside])),
        "mvs_opencv_mae_um": float(np.abs(theirs - scene.height_um)[inside].mean()),
        "mvs_process_peak_mb": peak_kb / (1e6 if sys.platform == "darwin" else 1e3),
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
