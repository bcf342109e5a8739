//! A picture to draw, as text that can be posted to a worker.

use crate::{address, format::Format, refusal::Refusal, rig::Rig, state::State};
use luminaire_render::scenes::{Example, turntable};

/// Lights above the turntable, for measuring: their number, and the side of their shadow maps in
/// texels.
pub(crate) type Load = (usize, Option<u16>);

/// Everything that a picture depends on. The text of a job is a state's address after the size, the
/// load and the scene, each before a space.
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
    format!("{}x{} {spots}x{side} {} {address}", size.0, size.1, state.scene.name())
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
        let mut words = text.splitn(4, ' ');
        let mut pair = || -> Option<(u32, u32)> {
            let (one, other) = words.next()?.split_once('x')?;
            Some((one.parse().ok()?, other.parse().ok()?))
        };
        let (size, (spots, side)) = pair().zip(pair()).ok_or_else(refused)?;
        let side = u16::try_from(side).map_err(|_| refused())?;
        let load = (spots > 0).then_some((spots as usize, Some(side).filter(|&side| side > 0)));
        let (scene, address) = words.next().zip(words.next()).ok_or_else(refused)?;
        let scene = address::scene_named(scene)?;
        let kept = before.filter(|before| (before.job.state.scene, before.job.load) == (scene, load));
        let rig = kept.map_or_else(|| rig(scene, load), |before| Ok(before.rig))?;
        let (state, refused) = address::parse_in(scene, rig.lights(), address);
        match refused.into_iter().next() {
            Some(refusal) => Err(refusal),
            None => Ok(Self { rig: rig.fitted(&state)?, job: Job { size, load, state } }),
        }
    }
}

/// Returns a scene as it was composed, or the turntable under a load.
pub(crate) fn rig(scene: Example, load: Option<Load>) -> Result<Rig, Refusal> {
    let Some((spots, side)) = load else { return Ok(Rig::new(scene.setup()?)?) };
    let rig = Rig::new(turntable(spots)?)?;
    Ok(side.map_or(rig.clone(), |side| rig.with_shadow_side(side)))
}

/// Writes the job to draw a scene as it opens.
pub(crate) fn write_opened(scene: Example, size: (u32, u32)) -> String {
    let state = State::of(scene, 0);
    format!("{}x{} 0x0 {} {}", size.0, size.1, scene.name(), address::write(&state, 0))
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
        let rig = rig(Example::Turntable, load).unwrap();
        let mut stage = Stage::with_rig(Example::Turntable, rig);
        stage.switch("shadow", true).unwrap();
        let text = write((96, 54), load, stage.state(), stage.rig().lights());
        let task = Task::read(&text, None).unwrap();
        let fixtures = task.rig.fixtures_at(0.0).unwrap();
        assert_eq!((fixtures.len(), task.job.load), (5, load));
        assert!(fixtures.iter().all(|fixture| fixture.shadow().is_some_and(|(side, _)| side == 256)));
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
