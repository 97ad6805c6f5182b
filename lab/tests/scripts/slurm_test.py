#!/usr/bin/env python3
"""slurm_test.py FOLDER SCRIPT RUN PROGRAM: runs the sweep of sweep_test.py's FOLDER with SCRIPT, the job script for Slurm,
in four tasks of an array on a Slurm of its own: munged, slurmctld and two nodes (slurmd) on this machine, in a temporary
folder. One node is killed with all that runs on it while its tasks are in the middle. Slurm queues them again, they go on
where they were, and the table is that of one process, bit for bit. Skipped (77) where Slurm is not installed."""
import contextlib
import getpass
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PROGRAMS = ["munged", "slurmctld", "slurmd", "sbatch", "scontrol", "squeue", "sinfo"]
TASKS = 4


def expect(what: str, true: bool, seen: object = "") -> None:
    if not true:
        raise AssertionError(f"failed: {what}: {seen}")


def wait_for(what: str, condition, seconds: float) -> None:
    end = time.monotonic() + seconds
    while not condition():
        expect(f"{what} within {seconds} s", time.monotonic() < end)
        time.sleep(0.1)


def free_port() -> int:
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return listener.getsockname()[1]


def said(*command: object) -> str:
    ended = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=30)
    expect(f"{command[0]} ends with 0", ended.returncode == 0, ended.stdout + ended.stderr)
    return ended.stdout


def processes() -> dict[int, tuple[int, str]]:
    """Parent and command line of every process."""
    found = {}
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        with contextlib.suppress(OSError, ValueError):
            parent = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
            found[int(entry.name)] = parent, (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
    return found


class Cluster:
    """Slurm on this machine alone: its own key, ports and folders, and no accounting."""

    def __init__(self, folder: Path, stack: contextlib.ExitStack):
        self.folder, self.stack = folder, stack
        (folder / "state").mkdir()
        key = folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self.configure()
        self.start("munged", "--foreground", "--force", f"--socket={folder}/munge", f"--key-file={key}",
                   f"--pid-file={folder}/munged.pid", f"--seed-file={folder}/seed", f"--log-file={folder}/munged.log")
        wait_for("munged's socket", (folder / "munge").exists, 20)
        self.start("slurmctld", "-D")
        self.nodes = {name: self.start("slurmd", "-D", "-N", name) for name in ["n1", "n2"]}
        wait_for("two idle nodes", lambda: said("sinfo", "-h", "-N", "-o", "%T").split() == ["idle"] * 2, 30)

    def configure(self) -> None:
        host, user, folder = socket.gethostname().partition(".")[0], getpass.getuser(), self.folder
        lines = [
            "ClusterName=sweep", f"SlurmctldHost={host}(127.0.0.1)", f"SlurmctldPort={free_port()}",
            f"SlurmUser={user}", f"SlurmdUser={user}", "AuthType=auth/munge", f"AuthInfo=socket={folder}/munge",
            f"StateSaveLocation={folder}/state", f"SlurmdSpoolDir={folder}/%n",
            f"SlurmctldPidFile={folder}/slurmctld.pid", f"SlurmdPidFile={folder}/%n.pid",
            f"SlurmctldLogFile={folder}/slurmctld.log", f"SlurmdLogFile={folder}/%n.log",
            "ProctrackType=proctrack/linuxproc", "TaskPlugin=task/none", "MpiDefault=none",
            "SelectType=select/cons_tres", "SelectTypeParameters=CR_CPU", "SlurmdParameters=config_overrides",
            "JobRequeue=1", "SchedulerParameters=sched_interval=1,bf_interval=1",
            *(f"NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={free_port()} CPUs=2" for name in ["n1", "n2"]),
            "PartitionName=all Nodes=n1,n2 Default=YES MaxTime=10 State=UP"]
        (folder / "slurm.conf").write_text("\n".join(lines) + "\n")
        version = int(said("slurmd", "-V").split()[-1].split(".")[0])
        # Nothing here needs control groups, and minimal roots have none. Older versions cannot switch them off, but look for
        # them at the start only to find out which kind there is.
        plugin = "disabled" if version >= 24 else "cgroup/v1"
        (folder / "cgroup.conf").write_text(f"CgroupPlugin={plugin}\n")
        os.environ["SLURM_CONF"] = str(folder / "slurm.conf")

    def start(self, *command: str) -> subprocess.Popen:
        output = self.stack.enter_context((self.folder / f"{command[0]}.{command[-1]}.out".replace("/", "-")).open("w"))
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT)
        self.stack.callback(process.wait)
        self.stack.callback(process.kill)
        return process

    def steps(self, node: str) -> list[int]:
        """The processes of the node's jobs: the daemons of their steps, and all that descends from these."""
        jobs = said("squeue", "-h", "-w", node, "-o", "%A").split()
        all_processes = processes()
        found = [pid for pid, (_, line) in all_processes.items() if any(f"[{job}.batch]" in line for job in jobs)]
        for pid in found:  # grows
            found += [child for child, (parent, _) in all_processes.items() if parent == pid and child not in found]
        return found

    def kill(self, node: str) -> None:
        """As if its power went off."""
        self.nodes[node].kill()
        for pid in self.steps(node):
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)


def tasks(what: str) -> list[str]:
    return said("squeue", "-h", "-r", "-o", what).split()


def run(folder: Path, script: str, program: list[str], cluster: Cluster) -> None:
    out = folder / "slurm"
    shutil.rmtree(out, ignore_errors=True)
    glint = cluster.folder / "glint"
    glint.write_text("#!/bin/sh\nexec " + " ".join(f"'{word}'" for word in program) + ' "$@"\n')
    glint.chmod(0o755)
    os.environ["GLINT"] = str(glint)
    job = said("sbatch", "--parsable", f"--array=0-{TASKS - 1}", f"--output={cluster.folder}/task.%a.log", script,
               folder / "plan.json", out).strip()

    names = [line.split()[0] for line in said(*program, "sweep", folder / "plan.json", "--list").splitlines()]

    def done(shard: int) -> int:
        return sum((out / "jobs" / f"{name}.json").exists() for name in names[shard::TASKS])

    each = len(names) // TASKS

    def in_middle(shard: int) -> bool:
        return 0 < done(shard) < each

    def on_second() -> dict[str, int]:
        """The tasks that run on the second node, and their shards."""
        return {task: int(task.partition("_")[2]) for task in said("squeue", "-h", "-w", "n2", "-o", "%i").split()}

    wait_for("tasks on both nodes", lambda: {"n1", "n2"} <= set(tasks("%N")), 30)
    shards = on_second().values()
    wait_for("a task of the second node in its middle", lambda: any(map(in_middle, shards)), 120)
    killed = on_second()
    cluster.kill("n2")
    at_kill = {shard: done(shard) for shard in killed.values()}
    expect("a task was killed in its middle", any(map(in_middle, at_kill)), at_kill)
    # Slurm would find out by itself after SlurmdTimeout, and then wait two minutes before it begins a task again.
    said("scontrol", "update", "nodename=n2", "state=down", "reason=killed")
    wait_for("its tasks are queued again", lambda: set(tasks("%i:%T")) >= {f"{task}:PENDING" for task in killed}, 30)
    for task in killed:
        said("scontrol", "update", f"jobid={task}", "starttime=now")
    wait_for("all tasks end", lambda: not tasks("%i"), 200)
    shown = said("scontrol", "show", "job", job)
    expect("the killed tasks ran twice", shown.count("Restarts=1") == len(killed), shown)
    expect("every task completed", shown.count("JobState=COMPLETED") == TASKS, shown)
    for shard, count in at_kill.items():
        log = (cluster.folder / f"task.{shard}.log").read_text()
        expect("what was done is not done again", f"{count} done before, {each - count} done now" in log, log)
    print(f"n2 was killed when of {each} results each its shards had {at_kill}; they went on on n1")

    merged = subprocess.run([*program, "sweep", "--merge", str(out)], capture_output=True, text=True)
    expect("the results can be merged", merged.returncode == 0, merged.stderr)
    for name in ["table.json", "table.csv"]:
        expect(f"{name} is that of one process", (out / name).read_bytes() == (folder / "one" / name).read_bytes())


def main() -> int:
    missing = [name for name in PROGRAMS if not shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (Debian's slurmctld, slurmd, slurm-client and munge)")
        return 77
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    folder, script, program = Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
    with contextlib.ExitStack() as stack:
        work = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="slurm")))
        try:
            run(folder, script, program, Cluster(work, stack))
        except (AssertionError, subprocess.SubprocessError) as error:
            print(error)
            for log in sorted(work.glob("*.log")) + sorted(work.glob("*.out")):
                print(f"--- {log.name}", *log.read_text(errors="replace").splitlines()[-15:], sep="\n")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
