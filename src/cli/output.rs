//! Output files: written next to their place and renamed into it when complete, or spooled and then copied to standard output.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use crate::cli::failure::Failure;

/// A file under writing that appears in its place only when [`Output::commit`] succeeds.
#[derive(Debug)]
pub struct Output {
    target: Target,
    writer: BufWriter<File>,
}

#[derive(Debug)]
enum Target {
    /// A regular file, and the file next to it that is written.
    File { place: PathBuf, beside: Beside },
    /// Standard output, from a spool file that nobody else sees.
    Spool(Beside),
}

/// A file that is removed unless it was renamed.
#[derive(Debug)]
struct Beside(PathBuf);

impl Drop for Beside {
    fn drop(&mut self) {
        // Gone already after a rename; otherwise there is nobody left to tell.
        let _ = fs::remove_file(&self.0);
    }
}

impl Output {
    /// Starts a file; `-` is standard output, which receives nothing before everything has succeeded.
    ///
    /// # Errors
    /// When the place is a folder, a link or a device, or its folder is missing or not writable.
    pub fn create(place: &Path) -> Result<Self, Failure> {
        if place.as_os_str() == "-" {
            let (beside, file) = create_spool(&std::env::temp_dir())?;
            return Ok(Self {
                target: Target::Spool(beside),
                writer: BufWriter::with_capacity(1 << 16, file),
            });
        }
        check_place(place)?;
        let (beside, file) = create_beside(beside_name(place)?, place)?;
        let target = Target::File { place: place.to_path_buf(), beside };
        Ok(Self { target, writer: BufWriter::with_capacity(1 << 16, file) })
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// When the last bytes cannot be written or the file cannot be renamed; nothing is left behind then.
    pub fn commit(self) -> Result<(), Failure> {
        let Self { target, writer } = self;
        let mut file = writer.into_inner().map_err(|error| machine_write(&target.naming(error.error())))?;
        match target {
            Target::File { place, beside } => {
                file.sync_all().map_err(|error| Failure::io(&place, "cannot be written", &error))?;
                fs::rename(&beside.0, &place)
                    .map_err(|error| Failure::io(&place, "cannot be written", &error))
            }
            Target::Spool(_beside) => {
                file.seek(SeekFrom::Start(0)).map_err(|error| machine_write(&error))?;
                let mut stdout = io::stdout().lock();
                io::copy(&mut file, &mut stdout)
                    .and_then(|_| stdout.flush())
                    .map_err(|error| Failure::standard_output(&error))
            }
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer.write(bytes).map_err(|error| self.target.naming(&error))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush().map_err(|error| self.target.naming(&error))
    }
}

impl Target {
    /// The error with the name of the output in front.
    fn naming(&self, error: &io::Error) -> io::Error {
        let name = match self {
            Self::File { place, .. } => place.display().to_string(),
            Self::Spool(_) => "standard output".to_string(),
        };
        io::Error::new(error.kind(), format!("{name}: {error}"))
    }
}

/// A write to an output that did not succeed.
pub fn machine_write(error: &io::Error) -> Failure {
    Failure::machine("the output cannot be written", error)
}

/// Only a regular file may be replaced: a rename over a link or device would destroy what others rely on.
fn check_place(place: &Path) -> Result<(), Failure> {
    let Ok(metadata) = fs::symlink_metadata(place) else { return Ok(()) };
    let kind = metadata.file_type();
    let wrong = match () {
        () if kind.is_dir() => "is a folder; name a file",
        () if kind.is_symlink() => "is a symbolic link; name the file itself",
        () if !kind.is_file() => "is not a regular file; write `-` for standard output",
        () if metadata.permissions().readonly() => "is read-only",
        () => return Ok(()),
    };
    Err(Failure::Refused(format!("{}: {wrong}", place.display())))
}

/// The hidden name in the same folder under which a file is written first.
pub fn beside_name(place: &Path) -> Result<PathBuf, Failure> {
    let Some(name) = place.file_name() else {
        return Err(Failure::Refused(format!("{}: is not a name that can be written", place.display())));
    };
    let mut hidden = std::ffi::OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{}.partial", std::process::id()));
    Ok(place.with_file_name(hidden))
}

/// Names tried for a spool file.
const MOST_SPOOL_NAMES: u32 = 1000;

/// A spool file under a name that nothing else has: a run that was killed may have left its own behind.
fn create_spool(folder: &Path) -> Result<(Beside, File), Failure> {
    let named = |number: u32| folder.join(format!("slipmode-{}-{number}.spool", std::process::id()));
    let free = (0..MOST_SPOOL_NAMES).find(|number| !named(*number).exists());
    let path = named(free.unwrap_or(MOST_SPOOL_NAMES));
    create_beside(path.clone(), &path)
}

/// A new file; messages name what it is to become.
fn create_beside(path: PathBuf, place: &Path) -> Result<(Beside, File), Failure> {
    let file = OpenOptions::new()
        .read(true)
        .write(true)
        .create_new(true)
        .open(&path)
        .map_err(|error| Failure::io(place, "cannot be created", &error))?;
    Ok((Beside(path), file))
}
