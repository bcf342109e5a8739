//! The channels of a DMX mode that control a beam.

use std::collections::HashSet;

use luminaire::Rgb;
use luminaire::dmx::{Channel, Patch};
use roxmltree::Node;

use super::geometry::{number, path, short};
use crate::lamp::Patched;
use crate::refusal::Refusal;

/// The most channels of a mode that are read, and the most sentences of what is left out.
const CHANNELS: usize = 4_096;
const NOTES: usize = 20;

/// The quantities of a light that a channel controls.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Quantity {
    Pan,
    Tilt,
    Zoom,
    Dimmer,
    Red,
    Green,
    Blue,
    White,
}

impl Quantity {
    /// Returns the quantity of an attribute of the standard, and whether the attribute takes a colour away.
    fn of(attribute: &str) -> Option<(Self, bool)> {
        Some(match attribute {
            "Pan" => (Self::Pan, false),
            "Tilt" => (Self::Tilt, false),
            "Zoom" => (Self::Zoom, false),
            "Dimmer" => (Self::Dimmer, false),
            "ColorAdd_R" | "ColorRGB_Red" => (Self::Red, false),
            "ColorAdd_G" | "ColorRGB_Green" => (Self::Green, false),
            "ColorAdd_B" | "ColorRGB_Blue" => (Self::Blue, false),
            "ColorSub_C" | "ColorRGB_Cyan" => (Self::Red, true),
            "ColorSub_M" | "ColorRGB_Magenta" => (Self::Green, true),
            "ColorSub_Y" | "ColorRGB_Yellow" => (Self::Blue, true),
            "ColorAdd_W" => (Self::White, false),
            _ => return None,
        })
    }
}

/// A channel of a mode.
struct Control<'a, 'i> {
    geometry: Option<&'a str>,
    /// The coarse and the fine one, 0 for none.
    slots: [u16; 2],
    attribute: &'a str,
    /// The first function, which begins at 0.
    function: Node<'a, 'i>,
    /// Why no light has the channel, if so.
    refused: Option<&'static str>,
}

impl<'a, 'i> Control<'a, 'i> {
    /// Reads a channel; `None` for a virtual one.
    fn of(node: Node<'a, 'i>) -> Option<Self> {
        let mut functions = node.descendants().filter(|node| node.has_tag_name("ChannelFunction"));
        let function = functions.next()?;
        let refused = if node.attribute("DMXBreak").is_some_and(|number| number.trim() != "1") {
            Some("it is in another address range")
        } else {
            functions.next().map(|_| "a part of its numbers has another function")
        };
        let attribute = function.attribute("Attribute")?;
        Some(Self { geometry: node.attribute("Geometry"), slots: slots(node)?, attribute, function, refused })
    }

    /// Returns the channel of a quantity between its physical values, those of the standard where the file has none: degrees of
    /// an angle, and shares from 0 to 1 of all else.
    fn channel(
        &self,
        quantity: Quantity,
        filters: bool,
        zoom: Option<(f64, f64)>,
    ) -> Result<Channel, Refusal> {
        let [from, to] =
            [number(self.function, "PhysicalFrom", 0.0)?, number(self.function, "PhysicalTo", 1.0)?];
        let share = |ends: [f64; 2]| {
            let [from, to] = ends.map(|share| share.clamp(0.0, 1.0) as f32);
            Channel::share(from, to)
        };
        let channel = match (quantity, zoom) {
            (Quantity::Pan | Quantity::Tilt, _) => Channel::degrees(from as f32, to as f32),
            (Quantity::Zoom, Some((least, most))) if least < most => {
                share([from, to].map(|angle| (angle - least) / (most - least)))
            }
            _ if filters => share([1.0 - from, 1.0 - to]),
            _ => share([from, to]),
        }?;
        let [coarse, fine] = self.slots;
        Ok(if fine == 0 { channel.at(coarse) } else { channel.at_fine(coarse, fine) }?)
    }
}

/// Returns the coarse and the fine slot of a channel, 0 for none; a third one is less than a step of 16 bits.
fn slots(channel: Node) -> Option<[u16; 2]> {
    let mut slots = channel.attribute("Offset")?.split(',').map(|slot| slot.trim().parse().ok());
    Some([slots.next()??, slots.next().map_or(Some(0), |slot| slot)?])
}

/// The channels of a mode.
pub(super) struct Channels<'a, 'i> {
    mode: String,
    all: Vec<Control<'a, 'i>>,
}

impl<'a, 'i> Channels<'a, 'i> {
    pub(super) fn of(mode: Node<'a, 'i>) -> Self {
        let nodes = mode.descendants().filter(|node| node.has_tag_name("DMXChannel"));
        Self { mode: short(mode, "Name"), all: nodes.filter_map(Control::of).take(CHANNELS).collect() }
    }

    /// Returns the channels for a beam, at address 1; `None` without any.
    ///
    /// The channels are those of the beam's geometry and of the geometries that it is in. `zoom` has the narrowest and the
    /// widest angle of the fixture.
    pub(super) fn patch(&self, beam: Node, zoom: Option<(f64, f64)>) -> Option<Patched> {
        let above: HashSet<_> = beam.ancestors().filter_map(|node| node.attribute("Name")).collect();
        let own = |control: &&Control| control.geometry.is_none_or(|name| above.contains(name));
        let (mut found, mut notes, mut others) = (Vec::new(), Vec::new(), Vec::new());
        for control in self.all.iter().filter(own) {
            let Control { attribute, slots: [slot, _], .. } = *control;
            let Some((quantity, filters)) = Quantity::of(attribute) else {
                if others.len() < NOTES && !others.contains(&attribute) {
                    others.push(attribute);
                }
                continue;
            };
            let is_taken = found.iter().any(|(own, _)| *own == quantity);
            let refused = control.refused.or(is_taken.then_some("another channel controls the same"));
            let reason = match refused.map(str::to_owned) {
                Some(reason) => reason,
                None => match control.channel(quantity, filters, zoom) {
                    Ok(channel) => {
                        found.push((quantity, channel));
                        continue;
                    }
                    Err(refusal) => refusal.at(path(control.function)).to_string(),
                },
            };
            notes.push(format!("`{attribute}` at slot {slot} is left out: {reason}"));
        }
        if found.is_empty() {
            return None;
        }
        notes.truncate(NOTES);
        if !others.is_empty() {
            let names: Vec<_> = others.iter().map(|name| format!("{name:.80}")).collect();
            notes.push(format!(
                "a light has nothing that these attributes of the mode control: {}",
                names.join(", ")
            ));
        }
        let mut patch = Patch::new();
        let [_, _, _, _, red, green, blue, _] = patch.channels();
        let mut color = Rgb::new(red, green, blue);
        for (quantity, channel) in found {
            match quantity {
                Quantity::Pan => patch = patch.with_pan(channel),
                Quantity::Tilt => patch = patch.with_tilt(channel),
                Quantity::Zoom => patch = patch.with_zoom(channel),
                Quantity::Dimmer => patch = patch.with_dimmer(channel),
                Quantity::White => patch = patch.with_white(channel),
                Quantity::Red => color.red = channel,
                Quantity::Green => color.green = channel,
                Quantity::Blue => color.blue = channel,
            }
        }
        Some(Patched { patch: patch.with_color(color), mode: self.mode.clone(), notes })
    }
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
                "a light has nothing that these attributes of the mode control: Gobo1",
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

    /// A filter and a primary colour of one channel of light: the second is told, and does not take the place of the first.
    #[test]
    fn second_channel_of_a_quantity_is_told() {
        let lamps = beams(&FIXTURE.replace("Gobo1", "ColorRGB_Red"), None).expect("a fixture");
        let [before, found] = [beams(FIXTURE, None).expect("a fixture"), lamps]
            .map(|lamps| lamps.lamps[0].patch.clone().expect("channels"));
        assert_eq!(found.patch, before.patch);
        let told = "`ColorRGB_Red` at slot 11 is left out: another channel controls the same";
        assert!(found.notes.iter().any(|note| note == told), "{found:?}");
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
