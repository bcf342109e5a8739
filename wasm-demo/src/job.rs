//! A picture to draw, as text that can be posted to a worker.

use crate::{address, format::Format, leds, refusal::Refusal, rig::Rig, state::State};
use luminaire_render::{
    Strip,
    scenes::{Example, tree, turntable},
};
use std::rc::Rc;

/// Lights above the turntable, for measuring: their number, and the side of their shadow maps in
/// texels.
pub(crate) type Load = (usize, Option<u16>);

/// Everything that a picture depends on. The text of a job is a state's address after the size, the
/// load, the scene and the LEDs of a file, each before a space.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Job {
    /// Width and height of the picture in pixels.
    pub(crate) size: (u32, u32),
    /// The lights of the turntable, if they are not the scene's own.
    pub(crate) load: Option<Load>,
    pub(crate) state: State,
}

/// Writes a job, for a scene with this number of lights.
pub(crate) fn write(size: (u32, u32), load: Option<Load>, state: &State, lights: usize) -> String {
    let (spots, side) = load.map_or((0, 0), |(spots, side)| (spots, side.unwrap_or(0)));
    // What plays changes nothing in a picture, and the other half is a picture of its own.
    let plays = State::of(state.scene, 0).plays;
    let state = State { plays, other: None, is_difference: false, ..state.clone() };
    let address = address::write(&state, lights);
    let leds = leds::written(state.leds.as_deref());
    format!("{}x{} {spots}x{side} {} {leds} {address}", size.0, size.1, state.scene.name())
}

/// Returns the number format of a job, without building its scene.
pub(crate) fn format_of(text: &str) -> Result<Format, Refusal> {
    address::value_of(text, "format").map_or(Ok(State::of(Example::Show, 0).format), Format::named)
}

/// A job and its scene.
#[derive(Clone, Debug)]
pub(crate) struct Task {
    pub(crate) job: Job,
    pub(crate) rig: Rig,
}

impl Task {
    /// Reads a job. The scene is only built if it is not that of the task before.
    pub(crate) fn read(text: &str, before: Option<Self>) -> Result<Self, Refusal> {
        let refused = || Refusal::name("job", text, "a job that the stage has written");
        let mut words = text.splitn(5, ' ');
        let mut pair = || -> Option<(u32, u32)> {
            let (one, other) = words.next()?.split_once('x')?;
            Some((one.parse().ok()?, other.parse().ok()?))
        };
        let (size, (spots, side)) = pair().zip(pair()).ok_or_else(refused)?;
        let side = u16::try_from(side).map_err(|_| refused())?;
        let load = (spots > 0).then_some((spots as usize, Some(side).filter(|&side| side > 0)));
        let scene = address::scene_named(words.next().ok_or_else(refused)?)?;
        let (leds, address) = words.next().zip(words.next()).ok_or_else(refused)?;
        let leds = leds::read(leds).ok_or_else(refused)?.map(Rc::new);
        let is_kept = |job: &Job| (job.state.scene, job.load, &job.state.leds) == (scene, load, &leds);
        let kept = before.filter(|before| is_kept(&before.job));
        let rig = kept.map_or_else(|| rig(scene, load, leds.as_deref()), |before| Ok(before.rig))?;
        let (state, refused) = address::parse_in(scene, rig.lights(), address);
        let state = State { leds, ..state };
        match refused.into_iter().next() {
            Some(refusal) => Err(refusal),
            None => Ok(Self { rig: rig.fitted(&state)?, job: Job { size, load, state } }),
        }
    }
}

/// Returns a scene as it was composed, the tree with the LEDs of a file, or the turntable under a load.
pub(crate) fn rig(scene: Example, load: Option<Load>, leds: Option<&Strip>) -> Result<Rig, Refusal> {
    let Some((spots, side)) = load else {
        return Ok(Rig::new(leds.map_or_else(|| scene.setup(), |leds| tree::with_leds(leds.clone()))?)?);
    };
    let rig = Rig::new(turntable(spots)?)?;
    Ok(side.map_or(rig.clone(), |side| rig.with_shadow_side(side)))
}

/// Writes the job to draw a scene as it opens.
pub(crate) fn write_opened(scene: Example, size: (u32, u32)) -> String {
    write(size, None, &State::of(scene, 0), 0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::Stage;

    #[test]
    fn a_job_comes_back_with_its_scene() {
        let mut stage = Stage::of(Example::Show).unwrap();
        stage.switch("haze", false).unwrap();
        stage.put("exposure", 0.5).unwrap();
        stage.orbit(0.3, 0.1);
        assert!(stage.advance(1.7));
        let lights = stage.rig().lights();
        let text = write((960, 540), None, stage.state(), lights);
        let task = Task::read(&text, None).unwrap();
        assert_eq!((task.job.size, task.job.load, &task.job.state), ((960, 540), None, stage.state()));
        assert_eq!(task.rig.scene(), stage.rig().scene());
        assert_eq!(task.rig.fixtures_at(1.7).unwrap(), stage.rig().fixtures_at(1.7).unwrap());
        assert_eq!(task.rig.camera_of(&task.job.state), stage.camera());

        // The same scene again, and another one.
        assert!(stage.advance(0.1));
        let task = Task::read(&write((9, 5), None, stage.state(), lights), Some(task)).unwrap();
        assert_eq!((task.job.size, &task.job.state), ((9, 5), stage.state()));
        let task = Task::read(&write_opened(Example::Grid, (16, 9)), Some(task)).unwrap();
        assert_eq!(task.job.state, State::of(Example::Grid, task.rig.lights()));
        assert!(task.rig.lights() > 11);
        for format in Format::ALL {
            let text = write((9, 5), None, &State { format, ..task.job.state.clone() }, task.rig.lights());
            assert_eq!(format_of(&text), Ok(format));
        }
    }

    #[test]
    fn the_load_of_the_turntable_is_part_of_the_job() {
        let load = Some((5, Some(256)));
        let rig = rig(Example::Turntable, load, None).unwrap();
        let mut stage = Stage::with_rig(Example::Turntable, rig);
        stage.switch("shadow", true).unwrap();
        let text = write((96, 54), load, stage.state(), stage.rig().lights());
        let task = Task::read(&text, None).unwrap();
        let fixtures = task.rig.fixtures_at(0.0).unwrap();
        assert_eq!((fixtures.len(), task.job.load), (5, load));
        assert!(fixtures.iter().all(|fixture| fixture.shadow().is_some_and(|(side, _)| side == 256)));
    }

    /// A worker has each number of the LEDs to the bit, and keeps their scene until there are others.
    #[test]
    fn the_leds_of_a_file_are_part_of_the_job() {
        let mut stage = Stage::of(Example::Show).unwrap();
        let places = [-0.0, 2.0, 1.0 / 3.0, f32::MIN_POSITIVE, 0.0, -100.0];
        stage.put_leds(&places, &[0.0, 1.0, 0.0, 0.6, 0.0, -0.8]).unwrap();
        let job = |stage: &Stage| write((96, 54), None, stage.state(), stage.rig().lights());
        let task = Task::read(&job(&stage), None).unwrap();
        assert_eq!((task.job.state.scene, &task.job.state.leds), (Example::Tree, &stage.state().leds));
        let bits = |task: &Task| -> Vec<u32> {
            let places = task.rig.scene().strip().unwrap().places();
            places.iter().flat_map(|own| [own.x, own.y, own.z]).map(f32::to_bits).collect()
        };
        assert_eq!(bits(&task), places.map(f32::to_bits));

        stage.put_leds(&places[..3], &[]).unwrap();
        assert_eq!(stage.rig().scene().strip().unwrap().places().len(), 1);
        let task = Task::read(&job(&stage), Some(task)).unwrap();
        assert_eq!(bits(&task).len(), 3);
        stage.open("tree").unwrap();
        let task = Task::read(&job(&stage), Some(task)).unwrap();
        assert_eq!((task.job.state.leds, task.rig.scene().strip().unwrap().places().len()), (None, 500));
        let job = job(&stage).replace(" - ", " 00,zz ");
        assert!(Task::read(&job, None).is_err());
    }

    #[test]
    fn what_is_no_job_is_refused() {
        for text in ["", "16x9", "16 0x0 grid v=1", "16x9 0x0 nowhere v=1", "16x9 0x99999 grid v=1"] {
            assert!(Task::read(text, None).is_err(), "{text}");
        }
        let other = write_opened(Example::Grid, (16, 9)).replace("v=1", "v=1&format=f16");
        assert!(Task::read(&other, None).unwrap_err().to_string().contains("f16"));
    }
}
