//! A Slurm cluster of one machine under three names: its daemons, all of which end with this program.
//!
//! When a signal ends this program, the kernel ends the daemons; the supervisor of a task that runs just then goes on asking
//! for its controller until it is stopped.

use std::fs::{File, Permissions};
use std::io::Read;
use std::net::TcpListener;
use std::os::unix::fs::PermissionsExt;
use std::process::Child;

use super::{sessions, wait_until};
use crate::prelude::*;

const CONFIGURATION: &str = include_str!("../../cluster/slurm.conf");
/// The daemons in the order of their starts: name and command.
const DAEMONS: &str = include_str!("../../cluster/daemons.txt");

/// The nodes' names.
const NODES: [&str; 3] = ["n1", "n2", "n3"];

/// A running cluster; dropping it stops everything.
pub struct Cluster {
    place: PathBuf,
    daemons: Vec<(&'static str, Child)>,
}

impl Cluster {
    /// Starts the daemons in a new folder and waits until every node is idle.
    pub fn start(place: &Path) -> Result<Self> {
        make_folder(place).map_err(at(place))?;
        let mut cluster = Self { place: place.to_path_buf(), daemons: Vec::new() };
        for [name, words] in rows(DAEMONS) {
            // Slurm's configuration accepts no path with a space, so none is expected here.
            cluster.spawn(name, &words.replace("{place}", &place.display().to_string()))?;
            // All others need munge.
            wait_until("munge", || Ok(place.join("munge.sock").exists()))?;
        }
        wait_until("three idle nodes", || {
            // Until the controller listens, sinfo fails and says so; only its last word counts.
            let output =
                cluster.tool("sinfo", "--noheader").arg("--format=%D %t").stderr(Stdio::null()).output();
            Ok(output.is_ok_and(|output| output.stdout.trim_ascii() == b"3 idle"))
        })?;
        Ok(cluster)
    }

    /// Starts a daemon in the foreground that ends when this program does, however that comes about.
    fn spawn(&mut self, name: &'static str, words: &str) -> Result {
        let mut command = self.tool("setpriv", &format!("--pdeathsig TERM {words}"));
        let log = File::create(self.place.join(format!("{name}.out")));
        let daemon =
            log.and_then(|log| command.stdin(Stdio::null()).stdout(log.try_clone()?).stderr(log).spawn());
        self.daemons.push((name, daemon.map_err(at(name.as_ref()))?));
        Ok(())
    }

    /// A program of the cluster's user.
    fn tool(&self, name: &str, words: &str) -> Command {
        let mut command = program(name, words);
        command.env("SLURM_CONF", self.place.join("slurm.conf")).env("PATH", search_path(None));
        command
    }

    /// Runs the script that submits an array, for all its tasks or some.
    pub fn submit(&self, script: &str, tasks: Option<&str>) -> Result {
        self.tool("sh", "").arg(script).args(tasks).text().map(drop)
    }

    /// The indices of the array's tasks that squeue lists with these filters; the merge that waits for the array has none.
    pub fn tasks(&self, filters: &str) -> Result<Vec<usize>> {
        let listed = self.tool("squeue", &format!("--noheader --array --format=%K {filters}")).text()?;
        Ok(listed.lines().filter_map(|index| index.trim().parse().ok()).collect())
    }

    /// Cancels everything, and waits for what the living nodes run.
    pub fn cancel_all(&self) -> Result {
        self.tool("scancel", "--user root").text()?;
        wait_until("the cancelled tasks", || Ok(self.tasks("--states=RUNNING")?.is_empty()))
    }

    /// Kills a node at once: its daemon and every session that it started. Returns how many processes that were.
    pub fn kill_node(&mut self, node: &str) -> Result<usize> {
        let mut killed = 0;
        for (_, daemon) in self.daemons.iter_mut().filter(|(name, _)| *name == node) {
            daemon.kill().and_then(|()| daemon.wait()).map_err(|error| Failure::check(error.to_string()))?;
            killed += 1;
        }
        Ok(killed + sessions::kill(&self.marks(node))?)
    }

    /// What stands in the environment of everything that a node of this cluster runs.
    fn marks(&self, node: &str) -> [String; 2] {
        [format!("SLURMD_NODENAME={node}"), format!("SLURM_CONF={}/slurm.conf", self.place.display())]
    }

    /// Prints the ends of the daemons' logs.
    pub fn tell_logs(&self) {
        let logs = self.daemons.iter().map(|(name, _)| self.place.join(format!("{name}.out")));
        let _ = program("tail", "--lines=15").args(logs).code();
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

/// Makes the folder with the configuration and a key of random bytes that only we can read.
fn make_folder(place: &Path) -> std::io::Result<()> {
    fs::create_dir(place)?;
    // munge requires folders that only its user can write to.
    fs::set_permissions(place, Permissions::from_mode(0o755))?;
    fs::create_dir(place.join("state"))?;
    let mut bytes = vec![0; 1024];
    File::open("/dev/urandom")?.read_exact(&mut bytes)?;
    let key = place.join("munge.key");
    fs::write(&key, bytes)?;
    fs::set_permissions(key, Permissions::from_mode(0o400))?;
    fs::write(place.join("slurm.conf"), configuration(place, &free_ports()?))
}

/// Free ports: of the controller, and of each node.
fn free_ports() -> std::io::Result<Vec<u16>> {
    let listeners = (0..=NODES.len()).map(|_| TcpListener::bind("127.0.0.1:0"));
    let listeners = listeners.collect::<Result<Vec<_>, _>>()?;
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
    fn every_node_has_a_port_of_its_own() {
        let text = configuration(Path::new("/p"), &[1, 2, 3, 4]);
        assert!(
            text.contains("SlurmctldPort=1\n") && text.contains("NodeName=n3 ") && text.contains("Port=4 ")
        );
        assert!(text.contains("SlurmdSpoolDir=/p/spool-%n\n") && !text.contains('{'));
    }
}
