"""Commands of the comparison; ``python -m bench.pathtrace --help``."""

from __future__ import annotations

import argparse
import logging
from pathlib import Path

import numpy as np
from bench.pathtrace import photographs, report, samples
from bench.pathtrace.camera import Frame
from bench.pathtrace.tracer import start

from reliefscope.models.instrument import load_profile


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    frames = commands.add_parser("frames", help="photographs for `reliefscope import`")
    frames.add_argument("sample", help="fiducial-FINISH, regolith, forms or a height map .npz")
    frames.add_argument("--out", type=Path, required=True, help="new folder for the photographs")
    frames.add_argument("--truth", type=Path, help="file .npy for the true heights (H, W) in um")
    frames.add_argument("--rays", type=int, default=16, help="rays per pixel")
    frames.add_argument("--seed", type=int, default=1)
    frames.add_argument("--binning", type=int, default=2, help="sensor pixels per pixel and side")
    comparison = commands.add_parser("compare", help="both renderers: tables and pictures")
    comparison.add_argument("--out", type=Path, required=True, help="folder for the results")
    comparison.add_argument("--rays", type=int, default=32, help="rays per pixel")
    for command in (frames, comparison):
        command.add_argument("--threads", type=int, default=1, help="of the path tracer")
    arguments = parser.parse_args()
    logging.basicConfig(level=logging.INFO, format="%(message)s")
    start(arguments.threads)
    if arguments.command == "compare":
        report.write(arguments.out, arguments.rays)
    else:
        make_frames(arguments)


def make_frames(arguments: argparse.Namespace) -> None:
    profile = load_profile("benchtop")
    binning = arguments.binning
    shape = (profile.shape[0] // binning, profile.shape[1] // binning)
    pixel_um = profile.pixel_um * binning
    sample = samples.make(arguments.sample, profile.shape, profile.pixel_um)
    if arguments.truth is not None:
        np.save(arguments.truth, samples.true_heights(arguments.sample, sample, shape, pixel_um))
    path = photographs.photograph_set(
        sample,
        profile,
        Frame(shape, pixel_um),
        arguments.out,
        rays_per_pixel=arguments.rays,
        seed=arguments.seed,
        name=arguments.sample,
    )
    print(f"reliefscope import {path} --out RUN")


if __name__ == "__main__":
    main()
