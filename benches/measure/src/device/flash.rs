//! A board on a cable: the firmware is copied to the drive of its boot ROM, and the lines that it prints are read on
//! a serial port.

use std::io::{BufRead, BufReader, ErrorKind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{fs, thread};

use anyhow::{Context, Result, anyhow, bail, ensure};
use luminaire_stage::{FRAMES, Shown};
use serial2::SerialPort;
use tools::progress::Progress;

use super::lines::{Line, row};

/// Baud of the firmware's UART.
const BAUD: u32 = 115_200;
/// How long a drive is waited for, and how long a line.
const PATIENCE: Duration = Duration::from_secs(60);
/// Between two looks for a drive.
const PAUSE: Duration = Duration::from_millis(200);
/// Folders in which systems mount drives, and below which there is one for each user on some.
const MOUNTED: [&str; 4] = ["/media", "/run/media", "/mnt", "/Volumes"];
/// The file by which a boot ROM tells its board.
const ABOUT: &str = "INFO_UF2.TXT";
/// The line in it of an RP2040.
const BOARD: &str = "Board-ID: RPI-RP2";

/// The drive and the port of a board.
#[derive(Debug)]
pub(super) struct Cable {
    drive: Option<PathBuf>,
    port: SerialPort,
}

impl Cable {
    /// Opens the serial port, by default the only one.
    pub(super) fn new(drive: Option<PathBuf>, port: Option<PathBuf>) -> Result<Self> {
        let port = port.map_or_else(only_port, Ok)?;
        let mut port = SerialPort::open(&port, BAUD).with_context(|| {
            format!("--port {}: cannot open it; expected the serial port that reads GPIO 0", port.display())
        })?;
        port.set_read_timeout(PATIENCE)?;
        Ok(Self { drive, port })
    }

    /// Copies the firmware to the board, and reads a line of each picture. Returns the board's row of the table; an
    /// error if a checksum is not that of the host's pixels.
    pub(super) fn run(&self, image: &Path, progress: &Progress) -> Result<String> {
        let drive = drive(self.drive.as_deref(), progress)?;
        self.port.discard_buffers()?;
        progress.say("Copying", format_args!("{} to {}", image.display(), drive.display()));
        fs::copy(image, drive.join("luminaire.uf2"))
            .with_context(|| format!("cannot copy to {}", drive.display()))?;
        progress.say("Reading", format_args!("the lines of {} pictures", 2 + FRAMES));
        read(&self.port)
    }
}

/// Reads the lines of all pictures from a still on. Returns the board's row of the table.
fn read(port: &SerialPort) -> Result<String> {
    let is_still = |line: &Line| line.name == Shown::numbered(0).name;
    let mut lines = Vec::new();
    for bytes in BufReader::new(port).split(b'\n') {
        let bytes = bytes.map_err(|error| match error.kind() {
            ErrorKind::TimedOut => anyhow!(
                "nothing was received in {} s: expected lines at {BAUD} baud; does the port read GPIO 0, and share its \
                 ground?",
                PATIENCE.as_secs()
            ),
            _ => error.into(),
        })?;
        let line = Line::parse(String::from_utf8_lossy(&bytes).trim_end());
        // A board that starts sends noise, and one that runs half a line.
        if lines.is_empty() && !line.as_ref().is_ok_and(is_still) {
            continue;
        }
        let line = line?;
        line.is_of(&Shown::numbered(lines.len() as u32))?;
        lines.push(line);
        if lines.len() as u32 == 2 + FRAMES {
            break;
        }
    }
    row("your board", &lines).context("the port was closed before the first frame")
}

/// The only serial port of an adapter at this machine.
fn only_port() -> Result<PathBuf> {
    let mut ports = SerialPort::available_ports()?;
    // Linux lists ports of a mainboard as ttyS0 and so on, whether or not they exist.
    ports.retain(|port| !port.to_string_lossy().contains("/ttyS"));
    ensure!(
        ports.len() == 1,
        "--port is missing: expected the serial port that reads GPIO 0 of the board, found {ports:?}"
    );
    Ok(ports.swap_remove(0))
}

/// Waits for the drive of a board in its boot ROM.
fn drive(given: Option<&Path>, progress: &Progress) -> Result<PathBuf> {
    let start = Instant::now();
    let mut is_told = false;
    loop {
        let found = given.map_or_else(mounted, |folder| vec![folder.to_owned()]);
        let mut boards = found.into_iter().filter(|folder| is_board(folder));
        if let Some(board) = boards.next() {
            if let Some(other) = boards.next() {
                bail!("two boards, {} and {}: choose one by --drive", board.display(), other.display());
            }
            return Ok(board);
        }
        ensure!(
            start.elapsed() < PATIENCE,
            "no drive with `{BOARD}` in its {ABOUT}: hold BOOTSEL while you connect the board, mount its drive, and \
             name the folder by --drive if it is not below {}",
            MOUNTED.join(", ")
        );
        if !is_told {
            progress.say("Waiting", "for a board: hold BOOTSEL while you connect it");
            is_told = true;
        }
        thread::sleep(PAUSE);
    }
}

/// The folders at which drives may be mounted.
fn mounted() -> Vec<PathBuf> {
    let below = |folder: &Path| {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        entries.map(|entry| entry.path()).collect::<Vec<_>>()
    };
    let first: Vec<_> = MOUNTED.iter().flat_map(|folder| below(Path::new(folder))).collect();
    let second = first.iter().flat_map(|folder| below(folder));
    first.iter().cloned().chain(second).collect()
}

fn is_board(folder: &Path) -> bool {
    fs::read_to_string(folder.join(ABOUT))
        .is_ok_and(|about| about.lines().any(|line| line.trim_end() == BOARD))
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    /// Copies a program to a folder that looks like a drive, and answers on a port as a board does.
    fn flashed(board: &str, change: fn(String) -> String) -> Result<String> {
        let folder = tempfile::tempdir()?;
        fs::write(folder.path().join(ABOUT), format!("UF2 Bootloader v3.0\r\n{board}\r\n"))?;
        let image = folder.path().join("image");
        fs::write(&image, "image")?;
        let (port, other) = SerialPort::pair()?;
        let cable = Cable { drive: Some(folder.path().to_owned()), port };
        let written = || fs::read(folder.path().join("luminaire.uf2")).is_ok_and(|bytes| bytes == b"image");
        thread::scope(|scope| {
            scope.spawn(|| {
                while !written() {
                    thread::sleep(PAUSE);
                }
                let pictures = (0..2 + FRAMES).map(Shown::numbered);
                let lines = pictures.map(|shown| {
                    let (name, count) = (&shown.name, shown.pixels.len());
                    format!("{name}: {count} pixels, checksum {:08x}, 1330000 cycles\r\n", shown.checksum())
                });
                let text = change(lines.collect());
                other.write_all(&[b"\xff\xfe 7: 19200 pix\r\n", text.as_bytes()].concat()).expect("a port");
            });
            cable.run(&image, &Progress::kept())
        })
    }

    #[test]
    fn a_board_is_told_by_its_drive_and_every_checksum_is_compared() {
        assert_eq!(flashed(BOARD, |text| text).unwrap(), "| your board | 66 | 23.1 | 69.3 | 100.0 |");
        let wrong = |text: String| text.replacen("frame 63: 19200", "frame 63: 19201", 1);
        assert!(flashed(BOARD, wrong).unwrap_err().to_string().contains("frame 63"));
    }
}
