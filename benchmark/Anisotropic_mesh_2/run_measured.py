#!/usr/bin/env python3
# This file is part of Anisotropic_mesh_2.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : the Anisotropic_mesh_2 developers
"""Runs a command with a time limit and prints as JSON what it cost.

usage: run_measured.py SECONDS COMMAND [ARGUMENT...]

Linux counts the memory of the process that starts another one to the peak of
the latter. So scripts that hold meshes leave the start to this one, which
imports little: about 10 MB are the least that it can measure.
"""

import json
import os
import select
import signal
import sys
import time


def run(command, limit):
    start = time.perf_counter()
    # what the command prints must not mix with the JSON; its own process group
    # can be ended as a whole
    pid = os.posix_spawnp(command[0], command, os.environ, setpgroup=0,
                          file_actions=[(os.POSIX_SPAWN_DUP2, 2, 1)])
    is_done = False
    try:
        is_done = bool(select.select([os.pidfd_open(pid)], [], [], limit)[0])
    finally:
        seconds = time.perf_counter() - start
        os.killpg(pid, signal.SIGKILL)
        _, status, usage = os.wait4(pid, 0)
    return {"exit_status": os.waitstatus_to_exitcode(status) if is_done else None,
            "cpu_seconds": usage.ru_utime,
            "wall_seconds": seconds,
            "peak_bytes": 1024 * usage.ru_maxrss}


if __name__ == "__main__":
    print(json.dumps(run(sys.argv[2:], float(sys.argv[1]))))
