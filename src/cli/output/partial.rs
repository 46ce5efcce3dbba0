//! Unfinished outputs: hidden next to their place, under a name that nothing else has, removed on errors and on signals.
//!
//! The signals that users and schedulers send are caught. KILL and a power cut are not: they can leave `.NAME.RANDOM.partial` behind, which no later
//! run reads, needs or stumbles over, and which may be removed at any time.

use std::collections::BTreeSet;
use std::fs::{self, File, Permissions};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::{Builder, NamedTempFile, TempDir};

/// The unfinished outputs of this process. Whoever holds the lock can neither create nor replace one meanwhile.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// An entry of [`UNFINISHED`].
#[derive(Debug)]
struct Entry(PathBuf);

impl Drop for Entry {
    fn drop(&mut self) {
        unfinished().remove(&self.0);
    }
}

/// An unfinished file or folder; dropping it removes it with all it holds.
#[derive(Debug)]
pub struct Partial<T> {
    temporary: T,
    _entry: Entry,
}

pub type PartialFile = Partial<NamedTempFile>;
pub type PartialFolder = Partial<TempDir>;

impl PartialFile {
    /// Creates an empty file next to `place`.
    ///
    /// # Errors
    /// When the folder is missing or takes no files.
    pub fn beside(place: &Path) -> io::Result<Self> {
        register(|| builder(&prefix(place), 0o666).tempfile_in(folder_of(place)), NamedTempFile::path)
    }

    /// Puts the file in its place when its bytes are on the disk; an earlier file is replaced in one step.
    ///
    /// # Errors
    /// When the system refuses; the place is as it was then.
    pub fn persist(self, place: &Path) -> io::Result<()> {
        let Self { temporary: file, _entry } = self;
        file.as_file().sync_all()?;
        file.persist(place).map_err(|error| error.error)?;
        sync_folder(folder_of(place))
    }
}

impl io::Write for PartialFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.temporary.as_file_mut().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.temporary.as_file_mut().flush()
    }
}

impl PartialFolder {
    /// Creates an empty folder next to `place`.
    ///
    /// # Errors
    /// When the folder above is missing or takes no folders.
    pub fn beside(place: &Path) -> io::Result<Self> {
        register(|| builder(&prefix(place), 0o777).tempdir_in(folder_of(place)), TempDir::path)
    }

    /// Writes a file, and the folders it lies in, through to the disk.
    ///
    /// # Errors
    /// When the system refuses.
    pub fn write(&self, name: &str, content: &[u8]) -> io::Result<()> {
        let path = self.temporary.path().join(name);
        fs::create_dir_all(folder_of(&path))?;
        let mut file = File::create_new(&path)?;
        io::Write::write_all(&mut file, content)?;
        file.sync_all()
    }

    /// Puts the folder in its place; an earlier folder is exchanged for it in one step, and then removed.
    ///
    /// # Errors
    /// When the system refuses; the place holds the earlier or the new folder whole then.
    pub fn persist(self, place: &Path) -> io::Result<()> {
        let Self { temporary: folder, _entry } = self;
        sync_tree(folder.path())?;
        match fs::symlink_metadata(place) {
            Ok(_) => exchange(folder.path(), place)?,
            Err(_) => fs::rename(folder.path(), place)?,
        }
        sync_folder(folder_of(place))?;
        match folder.close() {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(bare(error)),
            _ => Ok(()),
        }
    }
}

/// Creates something and enters it among the unfinished, with no signal in between. The first one has signals caught from
/// then on; not in a program that runs commands as functions, such as Python, which has its own way with signals.
fn register<T>(
    create: impl FnOnce() -> io::Result<T>,
    path: impl FnOnce(&T) -> &Path,
) -> io::Result<Partial<T>> {
    static CATCHES_SIGNALS: AtomicBool = AtomicBool::new(false);
    let mut unfinished = unfinished();
    if !crate::cli::streams::is_capturing() && !CATCHES_SIGNALS.load(Ordering::Relaxed) {
        remove_on_signals()?;
        CATCHES_SIGNALS.store(true, Ordering::Relaxed);
    }
    let created = create().map_err(bare)?;
    let path = path(&created).to_path_buf();
    unfinished.insert(path.clone());
    Ok(Partial { temporary: created, _entry: Entry(path) })
}

fn builder(prefix: &str, mode: u32) -> Builder<'_, 'static> {
    let mut builder = Builder::new();
    builder.prefix(prefix).suffix(".partial");
    // The user's mask applies, as to any other file; without this only the owner could read a result.
    #[cfg(unix)]
    builder.permissions(<Permissions as std::os::unix::fs::PermissionsExt>::from_mode(mode));
    builder
}

/// The longest part of a name that its hidden name repeats, so that the hidden one is not too long where the name is not.
const LONGEST_PREFIX: usize = 60;

fn prefix(place: &Path) -> String {
    let name = place.file_name().unwrap_or_default().to_string_lossy();
    format!(".{}.", name.chars().take(LONGEST_PREFIX).collect::<String>())
}

/// The folder that a place lies in.
pub fn folder_of(place: &Path) -> &Path {
    place.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// An error without the hidden path that tempfile adds to its words: messages name the place.
fn bare(error: io::Error) -> io::Error {
    let words = error.to_string();
    let cause = words.split_once(" at path ").map_or(words.as_str(), |(cause, _)| cause);
    io::Error::new(error.kind(), cause)
}

/// Replaces a folder by another; the earlier one is left under the new one's old name.
#[cfg(any(target_os = "linux", target_os = "macos"))]
fn exchange(new: &Path, place: &Path) -> io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;
    match renameat_with(CWD, new, CWD, place, RenameFlags::EXCHANGE) {
        Err(Errno::INVAL | Errno::NOSYS | Errno::NOTSUP) => exchange_by_renames(new, place),
        exchanged => Ok(exchanged?),
    }
}

/// Replaces a folder by another; the earlier one is left under the new one's old name.
#[cfg(not(any(target_os = "linux", target_os = "macos")))]
use exchange_by_renames as exchange;

/// The exchange where the file system knows none. A kill between the first two renames leaves no folder in the place, and
/// the earlier one under a hidden name next to it; the lock keeps signals out of that moment.
fn exchange_by_renames(new: &Path, place: &Path) -> io::Result<()> {
    let _no_signal = unfinished();
    let old = builder(&prefix(place), 0o777).tempdir_in(folder_of(place)).map_err(bare)?;
    fs::rename(place, old.path())?;
    if let Err(error) = fs::rename(new, place) {
        // The earlier output goes back; if even that fails, the error above is the one that matters, and it stays.
        if fs::rename(old.path(), place).is_err() {
            let _ = old.keep();
        }
        return Err(error);
    }
    fs::rename(old.path(), new)
}

/// Brings the entries of a folder, and of those in it, to the disk; its files are there already.
fn sync_tree(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            sync_tree(&entry.path())?;
        }
    }
    sync_folder(folder)
}

/// Brings a folder's entries to the disk, where its file system lets a folder be synced.
fn sync_folder(folder: &Path) -> io::Result<()> {
    use io::ErrorKind::{InvalidInput, PermissionDenied, Unsupported};
    match File::open(folder).and_then(|folder| folder.sync_all()) {
        Err(error) if [InvalidInput, PermissionDenied, Unsupported].contains(&error.kind()) => Ok(()),
        synced => synced,
    }
}

/// Has [`caught_signals`] remove what is unfinished before they end the process as they always do.
///
/// # Errors
/// When the system gives no thread or signals.
#[cfg(unix)]
fn remove_on_signals() -> io::Result<()> {
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;
    let mut signals = Signals::new(caught_signals())?;
    let end = move || {
        if let Some(signal) = signals.forever().next() {
            // Held to the end, so that nothing new comes into being.
            let unfinished = unfinished();
            for path in unfinished.iter() {
                // What cannot be removed stays, as after a kill.
                let _ = fs::remove_file(path).or_else(|_| fs::remove_dir_all(path));
            }
            let _ = emulate_default_handler(signal);
        }
    };
    std::thread::Builder::new().name("signals".into()).spawn(end).map(drop)
}

/// Without signals there is nothing to catch.
#[cfg(not(unix))]
fn remove_on_signals() -> io::Result<()> {
    Ok(())
}

/// The signals to catch: not those that the caller has had ignored, as `nohup` does with HUP.
#[cfg(unix)]
fn caught_signals() -> Vec<i32> {
    use signal_hook::consts::{SIGALRM, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU};
    const CAUGHT: [i32; 7] = [SIGINT, SIGTERM, SIGUSR1, SIGUSR2, SIGQUIT, SIGALRM, SIGXCPU];
    match ignored_signals() {
        Some(mask) => {
            CAUGHT.into_iter().chain([SIGHUP]).filter(|signal| mask >> (signal - 1) & 1 == 0).collect()
        }
        // Where the system does not tell, HUP is left alone for the sake of `nohup`.
        None => CAUGHT.to_vec(),
    }
}

/// The mask of ignored signals, as Linux states it.
#[cfg(unix)]
fn ignored_signals() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"))?;
    u64::from_str_radix(mask.trim(), 16).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file system without an exchange: the renames leave the new folder in place and the earlier one under its old name.
    #[test]
    fn renames_exchange_two_folders() {
        let root = TempDir::new().unwrap();
        let (new, place) = (root.path().join("new"), root.path().join("place"));
        for (folder, text) in [(&new, "new"), (&place, "old")] {
            fs::create_dir(folder).unwrap();
            fs::write(folder.join("f"), text).unwrap();
        }
        exchange_by_renames(&new, &place).unwrap();
        assert_eq!(fs::read_to_string(place.join("f")).unwrap(), "new");
        assert_eq!(fs::read_to_string(new.join("f")).unwrap(), "old");
        assert!(exchange_by_renames(&root.path().join("missing"), &place).is_err());
        assert_eq!(fs::read_to_string(place.join("f")).unwrap(), "new", "the place is as it was");
        assert_eq!(fs::read_dir(root.path()).unwrap().count(), 2);
    }

    #[test]
    fn the_longest_name_has_a_hidden_one() {
        let root = TempDir::new().unwrap();
        let place = root.path().join("ü".repeat(127));
        PartialFile::beside(&place).unwrap().persist(&place).unwrap();
        assert!(place.is_file());
    }
}
