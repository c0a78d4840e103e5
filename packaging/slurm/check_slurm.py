#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Starts a Slurm cluster of two nodes on the loopback address, has clipc-slurm.sh compile a manifest there in parts, and loses the node
that runs one of them: the part goes on where it was, on the other node, and the merged index is that of a single run, byte for byte.

usage: check_slurm.py CLIPC SCRATCH_FOLDER
Skipped with exit code 77 where Slurm or munge is not installed.
"""

import contextlib
import json
import os
import pathlib
import pwd
import shutil
import signal
import socket
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = "munged slurmctld slurmd sbatch squeue scontrol".split()
SKIPPED = 77
PARTS = 5
LOST = 2  # the part whose node is lost
PATIENCE = 90  # seconds

CONFIGURATION = """\
ClusterName=clipc
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmUser={user}
SlurmdUser={user}
AuthInfo=socket={folder}/munge.socket,cred_expire=5
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1
SlurmdParameters=config_overrides
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=3
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=3
PartitionName=all Nodes=ALL Default=YES State=UP
"""

# The permutation N=12, M=0 of part 2 reads `gate.hlsli`. While there is none, the part ends there; WAITS, which stands for clipc, then
# leaves what a run leaves that is cut off, and does not end.
WAITS = f"""\
#!/bin/sh
"$REAL_CLIPC" "$@"
code=$?
[ $code -eq 1 ] || exit $code
rm out/index.{LOST}-of-{PARTS}.json
exec sleep 600
"""
SHADER = """\
#if N == 12 && M == 0
#include "gate.hlsli"
#endif
float4 main(float4 p : POSITION) : SV_Position { return p * (N + M / 2); }
"""
MANIFEST = {
    "version": 1,
    "options": ["-T", "vs_5_0"],
    "shaders": [{"source": "few.hlsl", "defines": {"N": list(range(20)), "M": [0, 1, 2]}}],
}
BEFORE = "made before the node was lost: "


def run(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode:
        sys.exit(f"{command}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout.strip()


def wait_for(what, condition):
    end = time.monotonic() + PATIENCE
    while not (found := condition()):
        if time.monotonic() > end:
            sys.exit(f"after {PATIENCE} seconds: no {what}")
        time.sleep(0.1)
    return found


def free_ports(count):
    with contextlib.ExitStack() as sockets:
        opened = [sockets.enter_context(socket.socket()) for _ in range(count)]
        for one in opened:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in opened]


class Cluster:
    """Two nodes, each with three processors, which this machine plays."""

    def __init__(self, folder):
        self.folder = folder
        (folder / "state").mkdir(parents=True)
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        folder.chmod(0o755)  # munge wants no other to write there
        configuration = folder / "slurm.conf"
        configuration.write_text(
            CONFIGURATION.format(
                host=socket.gethostname().split(".")[0],
                user=pwd.getpwuid(os.getuid()).pw_name,
                folder=folder,
                ports=free_ports(3),
            )
        )
        os.environ["SLURM_CONF"] = str(configuration)
        names = ("key", "socket", "pid", "log", "seed")
        files = [f"--{name}-file={folder}/munge.{name}" for name in names if name != "socket"]
        run("munged", "--force", f"--socket={folder}/munge.socket", "--num-threads=1", *files)

    def start(self):
        run("slurmctld")
        for node in ("n1", "n2"):
            run("slurmd", "-N", node)
        wait_for("idle nodes", lambda: run("sinfo", "-h", "-t", "idle", "-o", "%D") == "2")

    def lose(self, node):
        """Ends all processes of a node at once, and tells the controller, which would see it after a while."""
        daemon = self.pid(f"slurmd-{node}")
        end(daemon)
        end_steps(node, self.folder)
        run("scontrol", "update", f"NodeName={node}", "State=DOWN", "Reason=lost")

    def pid(self, name):
        with contextlib.suppress(OSError, ValueError):
            return int((self.folder / f"{name}.pid").read_text())
        return None

    def stop(self):
        for node in ("n1", "n2"):
            end_steps(node, self.folder)
        for name in ("slurmd-n1", "slurmd-n2", "slurmctld", "munge"):
            if (pid := self.pid(name)) and status(pid):
                os.kill(pid, signal.SIGTERM)
                wait_for(f"end of {name}", lambda pid=pid: not status(pid))


def end_steps(node, folder):
    """Ends the jobs of a node: what has its name in the environment, and what started that."""
    tree = {pid: parent_of(pid) for pid in processes()}
    ended = {
        pid
        for pid in tree
        if {f"SLURMD_NODENAME={node}", f"SLURM_CONF={folder}/slurm.conf"} < environment_of(pid)
    }
    ended |= {tree[pid] for pid in ended}
    for pid in ended - {0, 1, os.getpid()}:
        end(pid)


def processes():
    return [int(name) for name in os.listdir("/proc") if name.isdigit()]


def environment_of(pid):
    with contextlib.suppress(OSError):
        return set(pathlib.Path(f"/proc/{pid}/environ").read_text(errors="replace").split("\0"))
    return set()


def status(pid):
    with contextlib.suppress(OSError):
        lines = pathlib.Path(f"/proc/{pid}/status").read_text().splitlines()
        fields = dict(line.split(":", 1) for line in lines)
        return fields if not fields["State"].strip().startswith("Z") else {}
    return {}


def parent_of(pid):
    return int(status(pid).get("PPid", 0))


def end(pid):
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, signal.SIGKILL)


def check(clipc, cluster, work):
    out, whole, gate = work / "out", work / "whole", work / "gate.hlsli"
    out.mkdir()
    whole.mkdir()
    (work / "few.hlsl").write_text(SHADER)
    (work / "shaders.json").write_text(json.dumps(MANIFEST))
    program = work / "waits.sh"
    program.write_text(WAITS)
    program.chmod(0o755)
    os.environ["REAL_CLIPC"] = clipc
    said = run(
        HERE / "clipc-slurm.sh", str(PARTS), "out", "--", "--batch=shaders.json",
        cwd=work, env=os.environ | {"CLIPC": str(program)},
    )  # fmt: skip
    array, merge = (words.split(";")[0] for words in said.split("job ")[1:])

    journal = out / f"index.{LOST}-of-{PARTS}.json.part"
    wait_for(
        "part that waits",
        lambda: (
            (out / f"part-{LOST}.log").exists()
            and "not compiled" in (out / f"part-{LOST}.log").read_text()
        ),
    )
    node = run("squeue", "-h", "-j", f"{array}_{LOST}", "-o", "%N")
    done = [json.loads(line)["files"]["glsl"] for line in journal.read_text().splitlines()[1:]]
    for file in done:
        (out / file).write_text(BEFORE + file)
    cluster.lose(node)
    gate.write_text("")
    # Slurm waits until what the lost node might still say has expired.
    run("scontrol", "update", f"JobId={array}_{LOST}", "StartTime=now")
    wait_for("end of the merge", lambda: merge not in run("squeue", "-h", "-o", "%A").split())

    run(clipc, "--batch=shaders.json", "-o", "whole", cwd=work)
    merged = (out / "index.json").read_bytes()
    if merged != (whole / "index.json").read_bytes():
        sys.exit("the merged index is not that of a single run")
    for file in {entry["files"]["glsl"] for entry in json.loads(merged)["shaders"]}:
        expected = BEFORE + file if file in done else (whole / file).read_text()
        if (out / file).read_text() != expected:
            sys.exit(f"{file} has other contents than that of a single run")
    if len(done) < 5 or journal.exists():
        sys.exit(f"a part that was interrupted after {done}, and resumed")
    print(f"slurm: passed; part {LOST} lost {node} after {len(done)} permutations and went on")


def main():
    clipc, scratch = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    missing = [name for name in PROGRAMS if not shutil.which(name)]
    if missing:
        print(f"skipped: there is no {', '.join(missing)}")
        sys.exit(SKIPPED)
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    cluster = Cluster(scratch / "cluster")
    try:
        cluster.start()
        check(clipc, cluster, scratch)
    finally:
        cluster.stop()


if __name__ == "__main__":
    main()
