"""A Slurm cluster of one node on the loopback interface, for tests: no systemd, no cgroups, no munge."""
import getpass
import os
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
AuthType=auth/none
AuthInfo=cred_expire=5
CredType=cred/none
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=50000,bf_interval=1
KillWait=2
MaxArraySize={max_array_size}
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=main Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    try:
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]
    finally:
        for one in sockets:
            one.close()


class SlurmCluster:
    def __init__(self, folder: Path, max_array_size=1001):
        self.folder = folder
        self.host = socket.gethostname().split(".")[0]
        controller_port, node_port = free_ports(2)
        for name in ("state", "spool"):
            (folder / name).mkdir(parents=True)
        configuration = folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(
            folder=folder, host=self.host, user=getpass.getuser(), controller_port=controller_port, node_port=node_port,
            max_array_size=max_array_size))
        self.environment = {**os.environ, "SLURM_CONF": str(configuration)}
        self.controller = None
        self.node = None

    def __enter__(self):
        self.controller = self.start([shutil.which("slurmctld") or "/usr/sbin/slurmctld", "-D", "-c"])
        self.start_node()
        self.wait_for(lambda: "idle" in self.run("sinfo", "--noheader", "--format=%t"), "the node is idle")
        return self

    def __exit__(self, *_):
        self.run("scancel", f"--user={getpass.getuser()}")
        for process in (self.node, self.controller):
            process.terminate()
            process.wait(20)

    def start(self, command):
        return subprocess.Popen(command, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def start_node(self):
        self.node = self.start([shutil.which("slurmd") or "/usr/sbin/slurmd", "-D", "-N", self.host])

    def kill_node(self):
        """Kills the node's daemon; its tasks continue."""
        self.node.send_signal(signal.SIGKILL)
        self.node.wait()

    def run(self, *command):
        """Returns what the command prints; nothing if it fails."""
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False).stdout

    def states(self, job):
        """Returns the state of each task of a job that Slurm still knows: {'3_0': 'RUNNING', ...}."""
        lines = self.run("squeue", "--noheader", "--array", "--states=all", f"--jobs={job}", "--format=%i %T").split("\n")
        return dict(line.split() for line in lines if line)

    def wait_for(self, condition, what, seconds=120):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if condition():
                return
            time.sleep(0.1)
        log = (self.folder / "slurmctld.log").read_text()[-2000:]
        raise TimeoutError(f"after {seconds} s, it is not so that {what}\n{self.run('squeue')}{log}")
