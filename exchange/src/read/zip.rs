//! Zips, whose files are unpacked to bounded sizes.

use std::borrow::Cow;

use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_with_limit};
use rawzip::{
    CompressionMethod, ZipArchive, ZipArchiveEntryWayfinder, ZipSliceArchive, ZipVerification, crc32,
};

use crate::refusal::Refusal;

/// A zip.
pub(crate) struct Zip<'a> {
    /// The parameter and the expected value of a refusal.
    what: [&'static str; 2],
    archive: ZipSliceArchive<&'a [u8]>,
}

/// A file in a zip.
#[derive(Clone, Copy)]
pub(crate) struct Entry {
    place: ZipArchiveEntryWayfinder,
    method: CompressionMethod,
    is_encrypted: bool,
}

impl Entry {
    /// Returns whether the file is in the zip as it is.
    pub(crate) fn is_stored(self) -> bool {
        self.method == CompressionMethod::STORE
    }
}

impl<'a> Zip<'a> {
    /// Opens a zip. `what` is the parameter of a refusal, and what is expected.
    ///
    /// # Errors
    /// No zip.
    pub(crate) fn open(what: [&'static str; 2], bytes: &'a [u8]) -> Result<Self, Refusal> {
        let archive = ZipArchive::from_slice(bytes).map_err(|error| Refusal::new(what[0], error, what[1]))?;
        Ok(Self { what, archive })
    }

    fn refused(&self, error: rawzip::Error) -> Refusal {
        Refusal::new(self.what[0], error, self.what[1])
    }

    /// Calls a function with the path and the entry of each file. Of equal paths the last one counts: what is added to
    /// a zip replaces what was in it.
    ///
    /// # Errors
    /// A damaged directory.
    pub(crate) fn each(&self, mut file: impl FnMut(&[u8], Entry)) -> Result<(), Refusal> {
        for entry in self.archive.entries() {
            let entry = entry.map_err(|error| self.refused(error))?;
            let (place, method) = (entry.wayfinder(), entry.compression_method());
            let is_encrypted = entry.flags().is_encrypted();
            file(entry.file_path().as_ref(), Entry { place, method, is_encrypted });
        }
        Ok(())
    }

    /// Returns the file of a path.
    ///
    /// # Errors
    /// A damaged directory, or no such file.
    pub(crate) fn file(&self, path: &str) -> Result<Entry, Refusal> {
        let mut found = None;
        self.each(|own, entry| {
            if own == path.as_bytes() {
                found = Some(entry);
            }
        })?;
        found.ok_or_else(|| Refusal::new(self.what[0], "a zip without it", self.what[1]))
    }

    /// Returns the bytes of a file, at most `most`, whatever size the zip declares.
    ///
    /// # Errors
    /// An encrypted file, a method but deflate, damaged data, or too many bytes.
    pub(crate) fn unpack(&self, entry: Entry, most: usize) -> Result<Cow<'_, [u8]>, Refusal> {
        let file = self.archive.get_entry(entry.place).map_err(|error| self.refused(error))?;
        if entry.is_encrypted {
            return Err(Refusal::new(self.what[0], "an encrypted zip", "a zip without a password"));
        }
        let bytes = inflated(file.data(), entry.method, most)?;
        let found = ZipVerification { crc: crc32(&bytes), uncompressed_size: bytes.len() as u64 };
        file.claim_verifier().valid(found).map_err(|error| self.refused(error))?;
        Ok(bytes)
    }
}

/// Returns the bytes of packed data.
fn inflated(packed: &[u8], method: CompressionMethod, most: usize) -> Result<Cow<'_, [u8]>, Refusal> {
    let bytes: Cow<[u8]> = match method {
        CompressionMethod::STORE => packed.into(),
        // One byte more than is accepted.
        CompressionMethod::DEFLATE => match decompress_to_vec_with_limit(packed, most.saturating_add(1)) {
            Ok(bytes) => bytes.into(),
            Err(error) if error.status == TINFLStatus::HasMoreOutput => error.output.into(),
            Err(error) => return Err(Refusal::new("deflated data", error, "a whole file")),
        },
        _ => {
            let expected = "STORE or DEFLATE: unpack the file, and zip what was in it by one of these";
            return Err(Refusal::new("compression method", method.name().unwrap_or("unknown"), expected));
        }
    };
    if bytes.len() > most {
        return Err(Refusal::new("size", bytes.len(), format_args!("at most {most} bytes")));
    }
    Ok(bytes)
}

#[cfg(test)]
pub(crate) mod tests {
    use std::io::{self, Write};

    use miniz_oxide::deflate::compress_to_vec;
    use rawzip::ZipArchiveWriter;

    use super::*;

    /// Returns a zip of files, each with its bytes and how these are packed by a method.
    pub(crate) fn packed(files: &[(&str, &[u8], CompressionMethod, &[u8])]) -> Vec<u8> {
        let mut archive = ZipArchiveWriter::new(Vec::new());
        for (name, bytes, method, packed) in files {
            let entry = archive.new_file(name).compression_method(*method);
            let (mut entry, config) = entry.start().expect("a name");
            let mut text = config.wrap(io::sink());
            text.write_all(bytes).expect("a sink");
            let (_, declared) = text.finish().expect("a sink");
            entry.write_all(packed).expect("memory");
            entry.finish(declared).expect("memory");
        }
        archive.finish().expect("memory")
    }

    /// Returns a zip of files that are deflated.
    pub(crate) fn zipped(files: &[(&str, &[u8])]) -> Vec<u8> {
        let deflated: Vec<_> = files.iter().map(|(_, bytes)| compress_to_vec(bytes, 6)).collect();
        let own = files.iter().zip(&deflated);
        let own = own.map(|((name, bytes), packed)| (*name, *bytes, CompressionMethod::DEFLATE, &packed[..]));
        packed(&own.collect::<Vec<_>>())
    }
}
