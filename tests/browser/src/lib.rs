//! The promises of the page to its visitors, each tested in a real browser.

mod address;
mod angles;
mod axe;
mod chip;
mod code;
mod comparison;
mod contrast;
mod divided;
pub mod engines;
mod failure;
mod fit;
mod fixtures;
mod formats;
mod hidden;
mod hosting;
mod keyboard;
mod lights;
mod memory;
mod museum;
mod network;
mod picture;
mod price;
mod readout;
mod refusal;
mod rest;
pub mod shaders;
mod stage;
mod states;
mod workers;

use std::path::Path;

use anyhow::{Result, ensure};

use browser::{Browser, Engine, Page};
use tools::progress::Progress;
use tools::server::{self, Server};

/// A visitor: a browser, and a server of the demo for the time of the visit.
#[derive(Debug)]
pub struct Visitor {
    /// Their browser.
    pub browser: Box<dyn Browser>,
    /// The address of the demo.
    pub address: String,
    /// The size of the picture, as a part of the address.
    parameters: &'static str,
    _server: Server,
}

/// The part of the address that opens the still life, where nothing moves, and the mouse over the
/// picture moves the camera alone.
const STILL: &str = "#stage?scene=three-point&play=none&handles=0";

/// What a visitor does, which fails if a promise is broken.
pub type Visit = fn(&mut Visitor) -> Result<()>;

/// The name of a test and its function.
pub type Test = (&'static str, Visit);

/// The tests of every run: one or two for each promise.
pub const QUICK: [Test; 28] = [
    ("the page becomes ready without a complaint", picture::becomes_ready),
    ("the picture is lit by its lights, in several colours", picture::is_lit),
    ("at rest the picture has the resolution of the device", rest::has_the_resolution_of_the_device),
    ("the field slider changes the picture and leads the beam angle", angles::field_leads_beam),
    ("a refused field angle is told and leaves the picture alone", refusal::is_told_and_harmless),
    ("a light is aimed by mouse, as one step", lights::are_aimed_by_mouse),
    ("a light is selected in the picture and moved by keys", lights::are_moved_by_keys),
    ("the number formats agree as closely as stated", formats::agree),
    ("a narrow beam parts the cosine form from the versine form", comparison::narrow_beam_parts_the_forms),
    ("the halves of a divided picture differ as on the host", divided::differs_as_on_the_host),
    ("every exhibit of the museum shows the errors that the host computes", museum::shows_every_exhibit),
    ("every scene is drawn, and called for what it shows", stage::are_all_drawn),
    ("a scene is opened by its address", stage::are_opened_by_address),
    ("every setting is kept by the address", stage::are_kept_by_the_address),
    ("changes are undone, redone and reset", stage::changes_are_undone),
    ("the code of a light follows its settings", code::follows_the_settings),
    ("the page opens on the show, which plays unless motion is unwanted", stage::opens_on_the_show),
    ("a scene plays, and stops", stage::play),
    ("the stage is used by the keyboard alone", stage::keys_are_enough),
    ("the page draws by itself where workers do not start", workers::need_not_start),
    ("no task of the page takes longer than 50 ms", workers::leave_the_page_free),
    ("axe-core finds no fault in the views", axe::finds_nothing_in_the_views),
    ("a browser that refuses the canvas is told so", failure::without_canvas),
    ("a lost connection keeps views from opening, until it is back", failure::of_the_connection),
    ("the page asks nobody but its own server", network::stays_at_home),
    ("the page's policy forbids all other code and data", network::policy_forbids_the_rest),
    ("the price of a light follows the format and the tolerance", price::follows_the_format),
    ("the folder for static hosts works under a path", hosting::works_under_a_path),
];

/// The tests that `cargo xtask full` adds.
pub const MORE: [Test; 58] = [
    ("the chip in the page shows the right pixels, and is loaded when opened", chip::shows_the_right_pixels),
    ("the first picture and the chip are small", hosting::is_small),
    ("a picture that the canvas refused is shown with the next draw", picture::is_shown_again),
    ("the picture has the size that the address asks for", picture::has_the_asked_size),
    ("rest ends with a change", rest::ends_with_a_change),
    ("the beam slider changes the picture and leads the field angle", angles::beam_leads_field),
    ("a hard edge looks different from a soft one", angles::edge_changes_picture),
    ("bad intensities, zooms and colours are told and leave the picture alone", refusal::are_all_told),
    (
        "an empty field is no error, and a field that is left shows what is in force",
        refusal::ends_with_the_field,
    ),
    ("what a format refuses is told under no other control", refusal::of_a_format_stands_by_itself),
    ("a curve of too few or too many samples is refused", refusal::of_curves),
    ("every fixture can be chosen", fixtures::can_be_chosen),
    ("the intensity of a light is seen", fixtures::intensity_is_seen),
    ("the colour of a light is seen", fixtures::colour_is_seen),
    ("the wheel over a pool zooms its light and keeps its flux", lights::are_zoomed_by_wheel),
    ("beam and field angle are set on the curve", lights::angles_are_set_on_the_curve),
    ("each number format can be chosen", formats::can_be_chosen),
    ("every form answers every angle", comparison::every_form_answers_every_angle),
    ("the divider follows the mouse and the keys", comparison::divider_moves),
    ("a refused cone is told in words, with a remedy", comparison::refusal_is_told_with_a_remedy),
    ("bad values leave the comparison alone", comparison::bad_values_are_harmless),
    ("the scale of the errors is chosen", comparison::scale_is_chosen),
    ("the comparison is reached by its link", comparison::is_reached_by_its_link),
    ("the pictures of the comparison are timed", comparison::times_are_measured),
    ("prices stand beside the errors", comparison::prices_stand_beside_the_errors),
    (
        "a divided picture is covered by its difference, and kept by the address",
        divided::is_covered_and_kept_by_the_address,
    ),
    ("the control of the museum changes the errors", museum::control_changes_the_errors),
    ("bad values leave the museum alone", museum::bad_values_are_refused),
    ("landmarks, pictures and controls of the museum have names", museum::is_named),
    ("a picture of what a scene calls for is that of everything, bit for bit", stage::equal_everything),
    ("what an address cannot have is refused in words", stage::bad_addresses_are_told),
    ("lights are copied and removed", stage::lights_are_copied_and_removed),
    ("lights are added, up to a number", stage::lights_are_added),
    ("the code of a light is what the exporter writes, in every language", code::is_what_the_exporter_writes),
    ("the code of a light is copied, or selected", code::is_copied_or_selected),
    ("the code of a light that a language cannot hold is refused in words", code::refusals_are_told),
    ("the camera is moved by mouse and keys, and reset", stage::camera_is_moved),
    ("the page scrolls over the picture", stage::page_scrolls_over_the_picture),
    ("lights and effects of a scene are switched", stage::are_switched),
    ("a light that moves lets tiles be lit again that it touches, and no others", stage::tiles_are_lit_again),
    ("the map shows how many lights were evaluated, with a legend", stage::map_is_shown),
    ("the map of the lighting time adds up to it", stage::map_of_costs_adds_up),
    ("what a format cannot hold of a scene is refused in words", stage::refusals_are_told),
    ("scenes are measured, pass by pass", stage::are_measured),
    ("any number of workers draws the same bits", workers::draw_the_same_bits),
    ("drawing takes no more memory from picture to picture", workers::keep_to_their_memory),
    ("keys do what the mouse does in the picture", keyboard::does_every_gesture),
    ("a hidden page draws nothing, and goes on when it is seen", hidden::draws_nothing),
    ("a browser without simd is told so", failure::without_simd),
    ("a page that is opened as a file says so", failure::from_a_file),
    ("every view of the navigation can be opened", failure::of_no_view),
    ("fixed point is loaded when it is chosen, or that is told", failure::of_fixed_point),
    ("what decorates a picture may fail", failure::of_decorations),
    ("only the module's own end stops the demo", failure::of_the_module),
    ("the address is written when the visitor pauses", address::is_written_seldom),
    ("a browser that refuses an address is none the worse for it", address::may_be_refused),
    ("a time that is not of the last picture says so, and the others add up", readout::adds_up),
    ("forced colours hide nothing", contrast::forced_colours_hide_nothing),
];

/// The long tests, which only `cargo xtask full` runs, and only in the first engine.
pub const LONG: [Test; 6] = [
    ("no task of the other views takes longer than 50 ms", workers::leave_every_view_free),
    ("forced colours hide nothing in the other views", contrast::forced_colours_hide_nothing_elsewhere),
    ("axe-core finds no fault in any state, on a laptop and on a telephone", axe::finds_nothing_anywhere),
    ("no text is cut or covered, on four screens and at 200 %", fit::nothing_is_cut),
    ("the keyboard reaches every control, and shows where it is", keyboard::reaches_every_control),
    ("five minutes of the show take no more memory", memory::stays_for_five_minutes),
];

impl Visitor {
    /// Serves the demo's folder and starts a browser.
    pub fn evaluate(engine: Engine, site: &Path, progress: &Progress) -> Result<Self> {
        let server = Server::start(server::listen(0)?, site)?;
        let browser = engine.start(progress)?;
        // The tests of the first engine draw all sizes; a quarter of the pixels is enough for the
        // others.
        let parameters = if engine == Engine::ALL[0] { "?rest=0" } else { engines::SIZE };
        Ok(Self { browser, address: server.address(), parameters, _server: server })
    }

    /// Opens the page on the still life, where nothing moves, and waits until it is ready.
    fn ready(&mut self) -> Result<Page> {
        self.ready_at(STILL)
    }

    /// Opens the page at an address below the demo's, and waits until it is ready. Without
    /// parameters the picture at rest has the size of one that moves.
    fn ready_at(&mut self, query: &str) -> Result<Page> {
        self.ready_with(query, "")
    }

    /// Like [`ready_at`](Self::ready_at), in a browser that `script` has changed.
    fn ready_with(&mut self, query: &str, script: &str) -> Result<Page> {
        let parameters = if query.starts_with('?') { "" } else { self.parameters };
        let mut page = self.browser.open(&format!("{}{parameters}{query}", self.address), script)?;
        page.ready()?;
        page.settle()?;
        Ok(page)
    }

    /// Opens the page in a browser in which `script` has broken something, and waits until the page
    /// reports that it has failed.
    fn failed(&mut self, script: &str) -> Result<Page> {
        let mut page = self.browser.open(&self.address, script)?;
        let state = page.state()?;
        ensure!(state == "failed", "the page is {state}, as if nothing were wrong");
        Ok(page)
    }
}
