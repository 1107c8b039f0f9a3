#!/bin/bash
# mini-slurm.sh start DIR PORT: a Slurm cluster of two nodes on this machine, in that folder, on PORT … PORT+2.
# mini-slurm.sh lose DIR NODE: the node dies, with all jobs on it.
# mini-slurm.sh deafen DIR NODE: its daemon dies, while its jobs' processes go on, and nobody hears of them.
# mini-slurm.sh stop DIR: ends everything that belongs to it.
# Needs root, and the packages slurmctld slurmd slurm-client munge. Clients find it by SLURM_CONF=DIR/slurm.conf.
set -u
folder=$2

# Processes that have the folder in their command line or environment, but for this script and who calls it.
members()
{
    for process in /proc/[0-9]*; do
        grep -qsa mini-slurm.sh "$process/cmdline" ||
            { grep -qsa "$folder/" "$process/cmdline" "$process/environ" && echo "${process#/proc/}"; }
    done
}

case $1 in
start)
    port=$3
    host=$(hostname -s)
    mkdir -p "$folder"/{state,spool/n1,spool/n2,log,munge,run}
    chmod 711 "$folder"
    head -c 128 /dev/urandom > "$folder/munge/munge.key"
    chown -R munge:munge "$folder/munge" "$folder/run"
    chmod 700 "$folder/munge"
    chmod 600 "$folder/munge/munge.key"
    cat > "$folder/slurm.conf" <<CONF
ClusterName=mini
SlurmctldHost=$host(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket=$folder/run/munge.socket,cred_expire=5
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
SlurmctldPort=$port
StateSaveLocation=$folder/state
SlurmctldPidFile=$folder/log/ctld.pid
SlurmctldLogFile=$folder/log/ctld.log
SlurmdPidFile=$folder/log/d.%n.pid
SlurmdLogFile=$folder/log/d.%n.log
SlurmdSpoolDir=$folder/spool/%n
SwitchType=switch/none
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
JobCompType=jobcomp/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
ReturnToService=0
SlurmdTimeout=5
KillWait=2
SlurmdParameters=config_overrides
SchedulerParameters=batch_sched_delay=0,sched_min_interval=10000,sched_interval=1,bf_interval=1,defer_batch
NodeName=n[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=[$((port + 1))-$((port + 2))] CPUs=2 Sockets=1 CoresPerSocket=2 ThreadsPerCore=1 RealMemory=100000 State=UNKNOWN
PartitionName=main Nodes=n[1-2] Default=YES MaxTime=INFINITE State=UP
CONF
    runuser -u munge -- /usr/sbin/munged --key-file="$folder/munge/munge.key" --socket="$folder/run/munge.socket" \
        --log-file="$folder/munge/munged.log" --pid-file="$folder/munge/munged.pid" \
        --seed-file="$folder/munge/munged.seed" || exit 1
    export SLURM_CONF=$folder/slurm.conf
    slurmctld -c || exit 1
    slurmd -N n1 && slurmd -N n2 || exit 1
    for _ in $(seq 100); do
        [ "$(sinfo --noheader --states=idle --format=%D 2>/dev/null)" = 2 ] && exit 0
        sleep 0.2
    done
    sinfo >&2
    exit 1
    ;;
lose | deafen)
    kill -9 "$(cat "$folder/log/d.$3.pid")"
    for process in $(members); do
        if grep -qsaz "^SLURMD_NODENAME=$3\$" "/proc/$process/environ"; then
            parent=$(sed 's/.*) . \([0-9]*\).*/\1/' "/proc/$process/stat" 2>/dev/null)
            grep -qsa slurmstepd "/proc/$parent/comm" && kill -9 "$parent"
            [ "$1" = deafen ] || kill -9 "$process"
        fi
    done 2>/dev/null
    ;;
stop)
    for _ in 1 2 3; do
        processes=$(members)
        [ -z "$processes" ] || kill -9 $processes 2>/dev/null
        sleep 0.1
    done
    [ -z "$(members)" ]
    ;;
esac
