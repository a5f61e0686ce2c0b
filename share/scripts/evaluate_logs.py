"""The logs of ./dev evaluate: where they are, what judges them, what is run on them."""
import dataclasses
import os
import pathlib
import shlex

MRPT = pathlib.Path("/usr/share/mrpt/datasets")
SIMULATED = MRPT / "graphslam-engine-demos/action_observations_map"
ALL = ()
# The occupancy grid's variant takes hours on long logs with hardly a pose right.
NO_GRID = ("rtob-revisit", "mrpt-stock", "mrpt-dense", "mrpt-lm", "pcl", "odometry")


@dataclasses.dataclass(frozen=True)
class Log:
    """A log that all programs run over."""
    name: str
    title: str
    file: pathlib.Path  # below RTOB_DATASETS where it is relative
    truth: pathlib.Path | None = None  # relations or a trajectory
    truth_is_odometry: bool = False  # the log's odometry holds the corrected poses
    variants: tuple[str, ...] = ALL
    returns: bool = False  # ends where it began

    def inputs(self):
        return [self.file] + ([self.truth] if self.truth else [])

    def missing_file(self, datasets):
        """The first of its files that is not there."""
        return next((file for file in self.inputs() if not (datasets / file).is_file()), None)

    def shown(self, file):
        """As a reader of the docs would type it."""
        return shlex.quote(str(file)) if file.is_absolute() else f"$RTOB_DATASETS/{file}"


@dataclasses.dataclass(frozen=True)
class Runs:
    """Several logs of one place, whose maps must agree."""
    name: str
    title: str
    files: tuple[pathlib.Path, ...]

    def inputs(self):
        return list(self.files)

    missing_file = Log.missing_file
    shown = Log.shown


def path(text):
    return pathlib.Path(text)


def listed(*logs):
    return {log.name: log for log in logs}


LOGS = listed(
    Log("intel", "Intel", path("intel/intel.clf.bz2"), path("intel/intel.relations.gz"),
        variants=NO_GRID),
    Log("fr079", "fr079", path("fr079/fr079.clf.bz2"), path("fr079/fr079.relations.gz"),
        variants=NO_GRID),
    Log("killian", "Killian", path("mit-killian/mit-killian.reconstructed.clf.gz"),
        path("mit-killian/mit-killian.relations.gz"), variants=NO_GRID),
    Log("slambot", "slambot, the way back", path("slambot_rplidar/data_24JUL14_14m.norm.clf.gz"),
        returns=True),
    Log("slambot-long", "slambot, 73 m", path("slambot_rplidar/data_6AUG14_16m.norm.clf.gz")),
    Runs("mines", "mines", tuple(path(f"mines_urg/exp{k}.norm.clf.gz") for k in range(1, 5))),
    Log("fhw", "fhw", path("fhw_museum/fhw-corrected.log.gz"), truth_is_odometry=True),
    Log("malaga", "Málaga",
        MRPT / "2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog"),
    Log("simulated", "MRPT's simulation", SIMULATED / "simul.rawlog",
        SIMULATED / "simul.rawlog.GT.txt"),
)


def resolved(file):
    """Where a log's file is on this computer."""
    return pathlib.Path(os.environ.get("RTOB_DATASETS", "")) / file
