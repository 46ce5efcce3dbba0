//! A Slurm cluster of one machine under three names: its daemons, all of which end with this program.
//!
//! When a signal ends this program, the kernel ends the daemons; the supervisor of a task that runs just then goes on asking
//! for its controller until it is stopped.

use std::ffi::OsStr;
use std::fs::{self, File};
use std::net::TcpListener;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use super::sessions;
use super::wait_for;
use crate::failure::Failure;
use crate::process;
use crate::repository::failure;

const CONFIGURATION: &str = include_str!("../../cluster/slurm.conf");

/// The nodes' names.
const NODES: [&str; 3] = ["n1", "n2", "n3"];

/// A running cluster; dropping it stops everything.
pub struct Cluster {
    place: PathBuf,
    daemons: Vec<(&'static str, Child)>,
}

/// A task or job that the scheduler knows.
pub struct Task {
    /// Its index in the array; none of a job that is no array counts as the largest number.
    pub index: usize,
    /// The node on which it runs; empty while it waits.
    pub node: String,
    state: String,
}

impl Task {
    /// Whether it runs.
    pub fn is_running(&self) -> bool {
        self.state == "R"
    }

    /// Whether it is the merge that waits for the array.
    pub fn is_merge(&self) -> bool {
        self.index == usize::MAX
    }

    /// Reads a line `index state node`.
    fn parse(line: &str) -> Option<Self> {
        let mut words = line.split_whitespace();
        let index = words.next()?.parse().unwrap_or(usize::MAX);
        let state = words.next()?.to_string();
        Some(Self { index, state, node: words.next().unwrap_or_default().to_string() })
    }
}

impl Cluster {
    /// Starts the daemons in a new folder and waits until every node is idle.
    pub fn start(place: &Path) -> Result<Self, Failure> {
        let cannot = |error: std::io::Error| failure(place, &error);
        fs::create_dir(place).map_err(cannot)?;
        // munge requires folders that only its user can write to.
        fs::set_permissions(place, fs::Permissions::from_mode(0o755)).map_err(cannot)?;
        fs::create_dir(place.join("state")).map_err(cannot)?;
        write_key(place).map_err(cannot)?;
        fs::write(place.join("slurm.conf"), configuration(place, &free_ports().map_err(cannot)?))
            .map_err(cannot)?;
        let mut cluster = Self { place: place.to_path_buf(), daemons: Vec::new() };
        let at = |option: &str, name: &str| format!("{option}{}", place.join(name).display());
        let munged = [
            "--foreground".to_owned(),
            "--force".to_owned(),
            at("--socket=", "munge.sock"),
            at("--key-file=", "munge.key"),
            at("--pid-file=", "munged.pid"),
            at("--log-file=", "munged.log"),
            at("--seed-file=", "munged.seed"),
        ];
        cluster.spawn("munged", "munged", &munged)?;
        let socket = place.join("munge.sock");
        wait_for("munge", || Ok(socket.exists().then_some(())))?;
        let configuration = at("", "slurm.conf");
        cluster.spawn("slurmctld", "slurmctld", &["-D", "-c", "-f", &configuration])?;
        for node in NODES {
            cluster.spawn(node, "slurmd", &["-D", "-N", node, "-f", &configuration])?;
        }
        wait_for("three idle nodes", || {
            let mut command = cluster.tool("sinfo");
            // Until the controller listens, sinfo fails and says so; only its last word counts.
            let output = command.args(["--noheader", "--format=%D %t"]).stderr(Stdio::null()).output();
            Ok(output.is_ok_and(|output| output.stdout.trim_ascii() == b"3 idle").then_some(()))
        })?;
        Ok(cluster)
    }

    /// Starts a daemon in the foreground that ends when this program does, however that comes about.
    fn spawn(
        &mut self,
        name: &'static str,
        program: &str,
        arguments: &[impl AsRef<OsStr>],
    ) -> Result<(), Failure> {
        let cannot = |error: std::io::Error| failure(program.as_ref(), &error);
        let log = File::create(self.place.join(format!("{name}.out"))).map_err(cannot)?;
        let mut command = self.tool("setpriv");
        command.args(["--pdeathsig", "TERM", program]).args(arguments);
        command.stdin(Stdio::null()).stdout(log.try_clone().map_err(cannot)?).stderr(log);
        self.daemons.push((name, command.spawn().map_err(cannot)?));
        Ok(())
    }

    /// A program of the cluster's user.
    fn tool(&self, name: &str) -> Command {
        let mut command = Command::new(name);
        command.env("SLURM_CONF", self.place.join("slurm.conf")).env("PATH", process::search_path());
        command
    }

    /// Runs the script that submits an array, for all its tasks or some.
    pub fn submit(&self, script: &str, tasks: Option<&str>) -> Result<(), Failure> {
        process::output(self.tool("sh").arg(script).args(tasks)).map(drop)
    }

    /// What is queued or runs.
    pub fn tasks(&self) -> Result<Vec<Task>, Failure> {
        let listed =
            process::output(self.tool("squeue").args(["--noheader", "--array", "--format=%K %t %N"]))?;
        Ok(listed.lines().filter_map(Task::parse).collect())
    }

    /// Cancels everything, and waits for what the living nodes run.
    pub fn cancel_all(&self) -> Result<(), Failure> {
        process::output(self.tool("scancel").args(["--user", "root"]))?;
        wait_for("the cancelled tasks", || Ok((!self.tasks()?.iter().any(Task::is_running)).then_some(())))
    }

    /// Kills a node at once: its daemon and every session that it started. Returns how many processes that were.
    pub fn kill_node(&mut self, node: &str) -> Result<usize, Failure> {
        let mut killed = 0;
        for (name, daemon) in &mut self.daemons {
            if *name == node {
                daemon
                    .kill()
                    .and_then(|()| daemon.wait())
                    .map_err(|error| Failure::check(error.to_string()))?;
                killed += 1;
            }
        }
        Ok(killed + sessions::kill(&self.marks(node))?)
    }

    /// What stands in the environment of everything that a node of this cluster runs.
    fn marks(&self, node: &str) -> [String; 2] {
        [format!("SLURMD_NODENAME={node}"), format!("SLURM_CONF={}/slurm.conf", self.place.display())]
    }

    /// Prints the ends of the daemons' logs.
    pub fn tell_logs(&self) {
        for (name, _) in &self.daemons {
            let log = fs::read_to_string(self.place.join(format!("{name}.out"))).unwrap_or_default();
            let lines: Vec<&str> = log.lines().collect();
            eprintln!("--- {name}");
            lines[lines.len().saturating_sub(15)..].iter().for_each(|line| eprintln!("{line}"));
        }
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        // Whatever fails here has ended already, or the kernel ends it when we end.
        for (_, daemon) in self.daemons.iter_mut().rev() {
            let _ = daemon.kill().and_then(|()| daemon.wait());
        }
        for node in NODES {
            let _ = sessions::kill(&self.marks(node));
        }
    }
}

/// A key of random bytes that only we can read.
fn write_key(place: &Path) -> std::io::Result<()> {
    use std::io::Read;
    let mut key = vec![0; 1024];
    File::open("/dev/urandom")?.read_exact(&mut key)?;
    let path = place.join("munge.key");
    fs::write(&path, key)?;
    fs::set_permissions(path, fs::Permissions::from_mode(0o400))
}

/// Free ports: of the controller, and of each node.
fn free_ports() -> std::io::Result<Vec<u16>> {
    let listeners: Vec<TcpListener> =
        (0..=NODES.len()).map(|_| TcpListener::bind("127.0.0.1:0")).collect::<Result<_, _>>()?;
    listeners.iter().map(|listener| Ok(listener.local_addr()?.port())).collect()
}

/// The configuration with the folder, the host and the ports of the controller and of the nodes filled in.
fn configuration(place: &Path, ports: &[u16]) -> String {
    let host = fs::read_to_string("/proc/sys/kernel/hostname").unwrap_or_default();
    let host = host.trim().split('.').next().unwrap_or_default();
    let text = CONFIGURATION.replace("{place}", &place.display().to_string()).replace("{host}", host);
    let fill =
        |text: String, (at, port): (usize, &u16)| text.replace(&format!("{{port{at}}}"), &port.to_string());
    ports.iter().enumerate().fold(text, fill)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_the_queue_is_a_task_or_the_merge() {
        let task = Task::parse("3 R n2").unwrap();
        assert_eq!(
            (task.index, task.node.as_str(), task.is_running(), task.is_merge()),
            (3, "n2", true, false)
        );
        assert!(Task::parse("N/A PD").unwrap().is_merge());
        assert!(Task::parse("").is_none());
    }

    #[test]
    fn every_node_has_a_port_of_its_own() {
        let text = configuration(Path::new("/p"), &[1, 2, 3, 4]);
        assert!(
            text.contains("SlurmctldPort=1\n") && text.contains("NodeName=n3 ") && text.contains("Port=4 ")
        );
        assert!(text.contains("SlurmdSpoolDir=/p/spool-%n\n") && !text.contains('{'));
    }
}
