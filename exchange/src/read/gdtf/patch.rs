//! The channels of a DMX mode that control a beam.

use luminaire::Rgb;
use luminaire::dmx::{Channel, Patch};
use roxmltree::Node;

use super::geometry::{number, path, short};
use crate::lamp::Patched;
use crate::refusal::Refusal;

/// The quantities of a light that a channel controls, in the order in which they are applied.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Quantity {
    Pan,
    Tilt,
    Zoom,
    Dimmer,
    /// A primary colour by its index, and whether the channel filters it.
    Color(usize, bool),
    White,
}

impl Quantity {
    /// Returns the quantity of an attribute of the standard.
    fn of(attribute: &str) -> Option<Self> {
        Some(match attribute {
            "Pan" => Self::Pan,
            "Tilt" => Self::Tilt,
            "Zoom" => Self::Zoom,
            "Dimmer" => Self::Dimmer,
            "ColorAdd_R" | "ColorRGB_Red" => Self::Color(0, false),
            "ColorAdd_G" | "ColorRGB_Green" => Self::Color(1, false),
            "ColorAdd_B" | "ColorRGB_Blue" => Self::Color(2, false),
            "ColorSub_C" | "ColorRGB_Cyan" => Self::Color(0, true),
            "ColorSub_M" | "ColorRGB_Magenta" => Self::Color(1, true),
            "ColorSub_Y" | "ColorRGB_Yellow" => Self::Color(2, true),
            "ColorAdd_W" => Self::White,
            _ => return None,
        })
    }

    /// Returns the channel between two physical values, those of the standard where the file has none: degrees of an angle, and
    /// shares from 0 to 1 of all else.
    fn channel(self, [from, to]: [f64; 2], zoom: Option<(f64, f64)>) -> Result<Channel, Refusal> {
        let share = |from: f64, to: f64| {
            let [from, to] = [from, to].map(|share| share.clamp(0.0, 1.0) as f32);
            Channel::share(from, to)
        };
        let channel = match (self, zoom) {
            (Self::Pan | Self::Tilt, _) => Channel::degrees(from as f32, to as f32),
            (Self::Zoom, Some((least, most))) if least < most => {
                let [from, to] = [from, to].map(|angle| (angle - least) / (most - least));
                share(from, to)
            }
            (Self::Color(_, true), _) => share(1.0 - from, 1.0 - to),
            _ => share(from, to),
        };
        Ok(channel?)
    }
}

/// Returns the channels of a mode for a beam, at address 1; `None` without any.
///
/// The channels are those of the beam's geometry and of the geometries that it is in. `zoom` has the narrowest and the widest
/// angle of the fixture.
pub(super) fn patch(mode: Node, beam: Node, zoom: Option<(f64, f64)>) -> Option<Patched> {
    let above: Vec<_> = beam.ancestors().filter_map(|node| node.attribute("Name")).collect();
    let (mut found, mut notes, mut others) = (Vec::new(), Vec::new(), Vec::new());
    for node in mode.descendants().filter(|node| node.has_tag_name("DMXChannel")) {
        let functions: Vec<_> =
            node.descendants().filter(|node| node.has_tag_name("ChannelFunction")).collect();
        let Some(attribute) = functions.first().and_then(|function| function.attribute("Attribute")) else {
            continue;
        };
        if !node.attribute("Geometry").is_none_or(|name| above.contains(&name)) {
            continue;
        }
        let Some(slots) = slots(node) else { continue }; // a virtual channel
        let Some(quantity) = Quantity::of(attribute) else {
            others.push(format!("{attribute:.80}"));
            continue;
        };
        let mut leave =
            |reason: &str| notes.push(format!("`{attribute}` at slot {} is left out: {reason}", slots[0]));
        if node.attribute("DMXBreak").is_some_and(|number| number.trim() != "1") {
            leave("it is in another address range");
        } else if found.iter().any(|(own, _)| *own == quantity) {
            leave("another channel controls the same");
        } else if functions.len() > 1 {
            leave("a part of its numbers has another function");
        } else {
            match channel(functions[0], quantity, slots, zoom) {
                Ok(channel) => found.push((quantity, channel)),
                Err(refusal) => leave(&refusal.at(path(functions[0])).to_string()),
            }
        }
    }
    if found.is_empty() {
        return None;
    }
    if !others.is_empty() {
        others.dedup();
        let (count, names) = (others.len(), others[..others.len().min(20)].join(", "));
        notes.push(format!("{count} channels control what the light has not: {names}"));
    }
    let mut colors = [None; 3];
    let mut patch = Patch::new();
    for (quantity, channel) in found {
        patch = match quantity {
            Quantity::Pan => patch.with_pan(channel),
            Quantity::Tilt => patch.with_tilt(channel),
            Quantity::Zoom => patch.with_zoom(channel),
            Quantity::Dimmer => patch.with_dimmer(channel),
            Quantity::White => patch.with_white(channel),
            Quantity::Color(index, _) => {
                colors[index] = Some(channel);
                patch
            }
        };
    }
    let [_, _, _, _, own @ .., _] = patch.channels();
    let [red, green, blue] = [0, 1, 2].map(|index| colors[index].unwrap_or(own[index]));
    let patch = patch.with_color(Rgb::new(red, green, blue));
    Some(Patched { patch, mode: short(mode, "Name"), notes })
}

fn channel(
    function: Node,
    quantity: Quantity,
    slots: [u16; 2],
    zoom: Option<(f64, f64)>,
) -> Result<Channel, Refusal> {
    let ends = [number(function, "PhysicalFrom", 0.0)?, number(function, "PhysicalTo", 1.0)?];
    let channel = quantity.channel(ends, zoom)?;
    let [coarse, fine] = slots;
    Ok(if fine == 0 { channel.at(coarse) } else { channel.at_fine(coarse, fine) }?)
}

/// Returns the coarse and the fine slot of a channel, 0 for none; a third one is less than a step of 16 bits.
fn slots(channel: Node) -> Option<[u16; 2]> {
    let mut slots = channel.attribute("Offset")?.split(',').map(|slot| slot.trim().parse().ok());
    Some([slots.next()??, slots.next().map_or(Some(0), |slot| slot)?])
}

#[cfg(test)]
mod tests {
    use luminaire::dmx::{Channel, Patch};
    use luminaire::{Angle, Cone, Error, Rgb, SpotLight};

    use super::super::beams;

    const FIXTURE: &str = r#"<GDTF DataVersion="1.2"><FixtureType Name="Head"><Geometries><Geometry Name="Base"><Axis Name="Yoke">
<Axis Name="Tilt axis"><Beam Name="Lens" BeamAngle="8" FieldAngle="12"/></Axis></Axis>
<Beam Name="Halo" BeamAngle="20" FieldAngle="30"/></Geometry></Geometries><DMXModes><DMXMode Name="Extended"><DMXChannels>
<DMXChannel Geometry="Yoke" Offset="1,2"><LogicalChannel><ChannelFunction Attribute="Pan" PhysicalFrom="270" PhysicalTo="-270"/>
</LogicalChannel></DMXChannel>
<DMXChannel Geometry="Tilt axis" Offset="3, 4,5"><LogicalChannel><ChannelFunction Attribute="Tilt" PhysicalFrom="-135" PhysicalTo="135"/>
</LogicalChannel></DMXChannel>
<DMXChannel Geometry="Lens" Offset="6"><LogicalChannel><ChannelFunction Attribute="Dimmer"/></LogicalChannel></DMXChannel>
<DMXChannel Geometry="Lens" Offset="7"><LogicalChannel><ChannelFunction Attribute="Zoom" PhysicalFrom="40" PhysicalTo="8"/>
</LogicalChannel></DMXChannel>
<DMXChannel Geometry="Lens" Offset="8"><LogicalChannel><ChannelFunction Attribute="ColorSub_C"/></LogicalChannel></DMXChannel>
<DMXChannel Geometry="Lens" Offset="9"><LogicalChannel><ChannelFunction Attribute="ColorSub_Y"/></LogicalChannel></DMXChannel>
<DMXChannel Geometry="Lens" Offset="10"><LogicalChannel><ChannelFunction Attribute="ColorSub_M"/>
<ChannelFunction Attribute="ColorMacro1" DMXFrom="200/1"/></LogicalChannel></DMXChannel>
<DMXChannel Geometry="Lens" Offset="11"><LogicalChannel><ChannelFunction Attribute="Gobo1"/></LogicalChannel></DMXChannel>
<DMXChannel Geometry="Lens" Offset="None"><LogicalChannel><ChannelFunction Attribute="ColorAdd_W"/></LogicalChannel></DMXChannel>
<DMXChannel Geometry="Halo" Offset="12"><LogicalChannel><ChannelFunction Attribute="Dimmer" PhysicalTo="0.5"/></LogicalChannel></DMXChannel>
<DMXChannel Geometry="Base" Offset="13" DMXBreak="2"><LogicalChannel><ChannelFunction Attribute="ColorAdd_W"/></LogicalChannel></DMXChannel>
</DMXChannels></DMXMode></DMXModes></FixtureType></GDTF>"#;

    #[test]
    fn channels_are_those_of_the_beam_and_of_what_holds_it() -> Result<(), Error> {
        let lamps = beams(FIXTURE, None).expect("a fixture");
        let [lens, halo] = &lamps.lamps[..] else { panic!("expected two lights, found {lamps:?}") };
        let share = |from, to| Channel::share(from, to);
        let own = Patch::new().channels()[4];
        let expected = Patch::new()
            .with_pan(Channel::degrees(270.0, -270.0)?.at_fine(1, 2)?)
            .with_tilt(Channel::degrees(-135.0, 135.0)?.at_fine(3, 4)?)
            .with_dimmer(share(0.0, 1.0)?.at(6)?)
            .with_zoom(share(1.0, 0.0)?.at(7)?)
            .with_color(Rgb::new(share(1.0, 0.0)?.at(8)?, own, share(1.0, 0.0)?.at(9)?));
        let found = lens.patch.as_ref().expect("channels");
        assert_eq!((found.patch, found.mode.as_str()), (expected, "Extended"));
        assert_eq!(
            found.notes,
            [
                "`ColorSub_M` at slot 10 is left out: a part of its numbers has another function",
                "`ColorAdd_W` at slot 13 is left out: it is in another address range",
                "1 channels control what the light has not: Gobo1",
            ]
        );
        let halo = halo.patch.as_ref().expect("channels");
        assert_eq!(halo.patch, Patch::new().with_dimmer(share(0.0, 0.5)?.at(12)?));
        Ok(())
    }

    /// At rest the beam is along the axis, and a pan turns it about the fixture's own vertical.
    #[test]
    fn fixtures_are_mounted_along_an_axis() -> Result<(), Error> {
        let lamps = beams(FIXTURE, None).expect("a fixture");
        let lens = lamps.lamps[0].patch.as_ref().expect("channels");
        let cone = Cone::soft(Angle::degrees(20.0))?;
        let ends = [SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone)?.compile::<f32>()?; 2];
        // Pan and tilt in their middles, and a tilt by 90 degrees.
        let [rest, tilted] = [[128, 0, 128, 0], [128, 0, 213, 85]];
        for (axis, aside) in [
            ([0.0, -2.0, 0.0], [0.0, 0.0, -1.0]),
            ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
            ([3.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
            ([0.0, 0.0, -1.0], [0.0, 1.0, 0.0]),
        ] {
            let mut patched = lens.clone();
            patched.mount_along(axis).expect("an axis");
            let length = axis.iter().map(|c| c * c).sum::<f32>().sqrt();
            for (slots, expected) in [(rest, axis.map(|c| c / length)), (tilted, aside)] {
                let found = <[f32; 3]>::from(patched.patch.state(&slots).light(&ends).axis());
                let apart = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                // Half a step of the tilt is 1.0e-3 and of the pan 2.1e-3 radians from the middle.
                assert!(apart < 2.5e-3, "{axis:?} {slots:?}: {found:?}");
            }
        }
        assert!(lens.clone().mount_along([0.0; 3]).is_err());
        Ok(())
    }

    #[test]
    fn numbers_that_no_channel_has_are_left_out() {
        for (from, to, reason) in [
            ("\"270\"", "\"many\"", "PhysicalFrom = many: expected a finite number"),
            ("\"270\"", "\"99999\"", "value of the channel = 99999"),
            ("\"1,2\"", "\"1,600\"", "slot = 600: expected a whole number from 1 to 512"),
        ] {
            let lamps = beams(&FIXTURE.replace(from, to), None).expect("a fixture");
            let found = lamps.lamps[0].patch.as_ref().expect("channels");
            assert!(
                found.notes[0].starts_with("`Pan` at slot 1 is left out") && found.notes[0].contains(reason),
                "{found:?}"
            );
            assert_eq!(found.patch.channels()[0], Patch::new().channels()[0]);
        }
    }
}
