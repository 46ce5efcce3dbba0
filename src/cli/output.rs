//! Output files: written next to their place and renamed into it when complete, or spooled and then copied to standard output.

mod folder;
mod partial;
mod places;

use std::fs::{self, File};
use std::io::{self, BufWriter, IntoInnerError, Seek, SeekFrom, Write};
use std::os::fd::AsFd;
use std::path::{Path, PathBuf};

use crate::cli::failure::Failure;
use crate::cli::streams::{StandardOutput, is_capturing};
use partial::PartialFile;

pub use folder::{MadeFolder, OutputFolder};
pub use places::{check_input, note_input, note_input_folder};

/// A file under writing that appears in its place only when [`Output::commit`] succeeds.
#[derive(Debug)]
pub enum Output {
    /// A regular file, and the unfinished one next to it.
    File { place: PathBuf, partial: BufWriter<PartialFile> },
    /// Standard output, from a file without a name.
    Spool(BufWriter<File>),
}

/// Bytes collected before they are written.
const BUFFER_BYTES: usize = 1 << 16;

impl Output {
    /// Starts a file; `-` is standard output, which receives nothing before everything has succeeded.
    ///
    /// # Errors
    /// When the place is an input of the command, a folder, a link or a device, or its folder is missing or not writable.
    pub fn create(place: &Path) -> Result<Self, Failure> {
        if is_stream(place) {
            return Self::spool();
        }
        check_place(place)?;
        places::note_output(place, false).map_err(|why| Failure::place(place, why))?;
        Self::replace(place)
    }

    /// Starts the files that are wanted of two.
    ///
    /// # Errors
    /// As [`Self::create`].
    pub fn create_both([first, second]: [Option<&Path>; 2]) -> Result<[Option<Self>; 2], Failure> {
        Ok([first.map(Self::create).transpose()?, second.map(Self::create).transpose()?])
    }

    /// Starts a file in a folder of the command's own, of which it may have read the earlier version.
    ///
    /// # Errors
    /// When the folder is missing or not writable.
    pub fn replace(place: &Path) -> Result<Self, Failure> {
        if place.file_name().is_none() {
            return Err(Failure::place(place, "is not a name that can be written"));
        }
        let partial = PartialFile::beside(place).map_err(Failure::io(place, "cannot be created"))?;
        let partial = BufWriter::with_capacity(BUFFER_BYTES, partial);
        Ok(Self::File { place: place.to_path_buf(), partial })
    }

    fn spool() -> Result<Self, Failure> {
        let no_spool = |error: io::Error| Failure::machine("a temporary file cannot be created", &error);
        // A stream that is closed has no file, and nothing to overwrite.
        if !is_capturing()
            && let Ok(stdout) = io::stdout().as_fd().try_clone_to_owned()
        {
            places::note_standard_output(&File::from(stdout))
                .map_err(|why| Failure::Refused(format!("standard output: {why}")))?;
        }
        let file = tempfile::tempfile().map_err(no_spool)?;
        Ok(Self::Spool(BufWriter::with_capacity(BUFFER_BYTES, file)))
    }

    /// Writes the whole content and puts the file in its place.
    ///
    /// # Errors
    /// When the content cannot be written.
    pub fn finish(mut self, content: impl AsRef<[u8]>) -> Result<(), Failure> {
        self.write_all(content.as_ref())?;
        self.commit()
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// When the command has read the file that is there, or the system refuses; nothing is left behind then.
    pub fn commit(mut self) -> Result<(), Failure> {
        self.flush()?;
        match self {
            Self::File { place, partial } => {
                let cannot = Failure::io(&place, "cannot be written");
                let partial = partial.into_inner().map_err(|error| cannot(error.into_error()))?;
                places::check_output(&place, false).map_err(|why| Failure::place(&place, why))?;
                partial.persist(&place).map_err(cannot)
            }
            Self::Spool(writer) => {
                let mut file = writer.into_inner().map_err(IntoInnerError::into_error)?;
                file.seek(SeekFrom::Start(0))?;
                let copied = io::copy(&mut file, &mut StandardOutput).and_then(|_| StandardOutput.flush());
                copied.or_else(|error| Failure::of_standard_output(&error))
            }
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.attempt(|writer| writer.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.attempt(|writer| writer.flush())
    }
}

impl Output {
    /// Does something with the file; an error gets the name of the output in front.
    fn attempt<T>(&mut self, action: impl FnOnce(&mut dyn Write) -> io::Result<T>) -> io::Result<T> {
        let (done, name) = match self {
            Self::File { place, partial } => (action(partial), place.display().to_string()),
            Self::Spool(file) => (action(file), "a temporary file for standard output".to_string()),
        };
        done.map_err(|error| io::Error::new(error.kind(), format!("{name}: cannot be written: {error}")))
    }
}

/// Whether a place is a standard stream.
pub fn is_stream(place: &Path) -> bool {
    place.as_os_str() == "-"
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
    Err(Failure::place(place, wrong))
}
