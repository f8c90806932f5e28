#!/usr/bin/env bash
# A Slurm of one node, this one, for as long as a command runs:
#   one_node.sh COMMAND [ARGUMENT]...
# Needs Debian's slurm-wlm and munge, and root: slurmd starts jobs as their owners. All its files are in a folder
# that is removed afterwards; a Slurm that is installed here keeps its own settings.
set -euo pipefail
(($#)) || { echo "usage: $0 COMMAND [ARGUMENT]..." >&2; exit 2; }
((EUID == 0)) || { echo "$0: needs root" >&2; exit 1; }
for program in munged slurmctld slurmd; do
    command -v "$program" >/dev/null || { echo "$0: needs $program (slurm-wlm, munge)" >&2; exit 1; }
done
folder=$(mktemp -d)
chmod 755 "$folder"
daemons=()
stop() {
    ((${#daemons[@]})) && kill "${daemons[@]}" 2>/dev/null
    wait
    rm -rf "$folder"
}
trap stop EXIT

# Two daemons on one host, on ports that are free as a rule.
port=$((20000 + RANDOM % 10000))
node=$(hostname -s)
cat > "$folder/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
SlurmUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,bf_interval=1
ReturnToService=2
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
mkdir "$folder/state" "$folder/spool"
export SLURM_CONF=$folder/slurm.conf
head -c 1024 /dev/urandom > "$folder/munge.key"
chmod 600 "$folder/munge.key"
munged --force --foreground --socket="$folder/munge.socket" --key-file="$folder/munge.key" \
    --pid-file="$folder/munge.pid" --seed-file="$folder/munge.seed" > "$folder/munge.log" 2>&1 &
daemons+=($!)
for ((i = 0; i < 100; ++i)); do [[ -S $folder/munge.socket ]] && break || sleep 0.1; done
slurmctld -D > "$folder/slurmctld.log" 2>&1 &
daemons+=($!)
slurmd -D > "$folder/slurmd.log" 2>&1 &
daemons+=($!)
for ((i = 0; i < 300; ++i)); do
    [[ $(sinfo --noheader --format=%T 2>/dev/null) == idle ]] && break || sleep 0.1
done
if [[ $(sinfo --noheader --format=%T 2>/dev/null) != idle ]]; then
    tail -n 20 "$folder"/*.log >&2
    echo "$0: the node did not come up" >&2
    exit 1
fi
"$@"
