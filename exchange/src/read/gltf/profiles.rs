//! The photometric files of `EXT_lights_ies`: beside the scene, or within it.

use std::ops::Range;
use std::rc::Rc;

use super::super::json::index;
use super::super::uri::{data, unescaped};
use crate::record::Profile;
use crate::refusal::Refusal;
use crate::text::LARGEST;

/// Where a photometric file is: a URI, or without one the index of a view.
pub(super) struct Source<'a> {
    pub(super) uri: &'a str,
    pub(super) view: Option<f64>,
}

/// A part of a buffer: the buffer's index, and bytes.
pub(super) struct View {
    pub(super) buffer: f64,
    pub(super) start: f64,
    pub(super) length: f64,
}

/// The files of a scene, each looked up once.
pub(super) struct Profiles<'a> {
    files: Vec<Source<'a>>,
    views: Vec<View>,
    /// The URIs of the buffers.
    buffers: Vec<&'a str>,
    /// The second chunk of a GLB, which is the first buffer.
    chunk: &'a [u8],
    found: Vec<Option<Result<Profile, Refusal>>>,
    /// The content of the buffers that have it in their URI, once it was read.
    decoded: Vec<Option<Result<Vec<u8>, Refusal>>>,
    /// How many bytes were taken, which bounds the memory.
    taken: usize,
}

impl<'a> Profiles<'a> {
    pub(super) fn new(
        files: Vec<Source<'a>>,
        views: Vec<View>,
        buffers: Vec<&'a str>,
        chunk: &'a [u8],
    ) -> Self {
        let (found, decoded) = (vec![None; files.len()], vec![None; buffers.len()]);
        Self { files, views, buffers, chunk, found, decoded, taken: 0 }
    }

    /// Returns the number of the files that no light has.
    pub(super) fn unused(&self) -> usize {
        self.found.iter().filter(|found| found.is_none()).count()
    }

    /// Returns the file of an index below the number of files.
    ///
    /// # Errors
    /// No file, one that is not whole within the scene, or over 64 MiB of them there.
    pub(super) fn get(&mut self, at: usize) -> Result<Profile, Refusal> {
        if self.found[at].is_none() {
            self.found[at] = Some(self.profile(at));
        }
        self.found[at].clone().unwrap_or_else(|| Err(Refusal::new("uri", "none", "a file")))
    }

    fn profile(&mut self, at: usize) -> Result<Profile, Refusal> {
        let Source { uri, view } = self.files[at];
        match (data(uri), view) {
            (Some(content), _) => self.within(at, content?.into()),
            (None, _) if !uri.is_empty() => Ok(beside(uri, None)),
            (None, Some(view)) => self.viewed(at, view),
            (None, None) => {
                let expected = "the name of a file, `data:` with its content, or a bufferView in its place";
                Err(Refusal::new("uri", "none", expected))
            }
        }
    }

    /// Returns the file of a part of a buffer.
    fn viewed(&mut self, at: usize, view: f64) -> Result<Profile, Refusal> {
        let view = &self.views[index("bufferView", view, self.views.len())?];
        let whole = |name: &str, value: f64| index(name, value, LARGEST * 16);
        let buffer = index("buffer", view.buffer, self.buffers.len())?;
        let (start, length) = (whole("byteOffset", view.start)?, whole("byteLength", view.length)?);
        let (uri, part) = (self.buffers[buffer], start..start + length);
        if self.decoded[buffer].is_none() {
            self.decoded[buffer] = data(uri);
        }
        let content = match (&self.decoded[buffer], uri) {
            (Some(content), _) => content.as_ref().map_err(Clone::clone)?,
            (None, "") if buffer == 0 => self.chunk,
            (None, "") => {
                return Err(Refusal::new("buffer", buffer, "one with a uri, or the first one of a GLB"));
            }
            (None, file) => return Ok(beside(file, Some(part))),
        };
        let own = content.get(part).ok_or_else(|| {
            let expected = format_args!("a part of the {} bytes of its buffer", content.len());
            Refusal::new("bufferView", format_args!("{length} bytes from {start}"), expected)
        })?;
        let own = own.into();
        self.within(at, own)
    }

    /// Returns a file within the scene.
    fn within(&mut self, at: usize, content: Rc<[u8]>) -> Result<Profile, Refusal> {
        self.taken += content.len();
        if self.taken > LARGEST {
            let expected = format_args!("at most {LARGEST} bytes of all: export a part of the scene");
            return Err(Refusal::new("profiles within the scene", self.taken, expected));
        }
        let file = format!("EXT_lights_ies.lights[{at}]");
        Ok(Profile { file, content: Some(content), part: None, is_normalized: false, without: None })
    }
}

/// Returns a file beside the scene, or a part of it.
fn beside(uri: &str, part: Option<Range<usize>>) -> Profile {
    let file = String::from_utf8_lossy(&unescaped(uri)).into_owned();
    Profile { file, content: None, part, is_normalized: false, without: None }
}
