"""What the tables call the variants of rtob-slam compare."""

NAMES = {
    "mrpt-stock": "MRPT icp-slam, shipped ini",
    "mrpt-dense": "MRPT icp-slam, dense",
    "mrpt-lm": "MRPT icp-slam LM, shipped ini",
    "mrpt-grid": "MRPT icp-slam on a grid, shipped ini",
    "pcl": "the paper's recipe on PCL",
    "odometry": "odometry alone",
}


def is_rtob(variant):
    return variant.startswith("rtob-")


def title(variant):
    if is_rtob(variant):
        return f"**RTOB-SLAM** ({variant.removeprefix('rtob-')})"
    return NAMES.get(variant, variant)
