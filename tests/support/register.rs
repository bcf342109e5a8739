//! Which test holds each public function of the core, and each kind of profile, distance, highlight, light
//! and format.
//!
//! A function that computes is bounded, two-sided, by the row or figure that the named test measures; one
//! that stores, gives back or refuses is exact, and the named test compares it.

/// A test, and what it holds.
pub(crate) struct Held {
    /// As `path::name`.
    pub(crate) test: &'static str,
    pub(crate) items: &'static [&'static str],
    /// Whether the test calls them itself, and not only what is made of them.
    pub(crate) is_named: bool,
}

const fn by(test: &'static str, items: &'static [&'static str]) -> Held {
    Held { test, items, is_named: true }
}

/// What a test reaches through something that it does call.
const fn through(test: &'static str, items: &'static [&'static str]) -> Held {
    Held { test, items, is_named: false }
}

/// The traits whose every implementation is something to choose, and so something to hold.
pub(crate) const KINDS: [&str; 6] = ["Profile", "Attenuation", "Specular", "Highlight", "Light", "Scalar"];

#[rustfmt::skip]
/// What no program that is linked without a panic is seen to call, and why.
pub(crate) const UNPROVED: &[(&str, &[&str])] = &[
    (
        "source is written on the host, by build scripts",
        &[
            "Source::write", "Source::as_source", "Named::write_name", "Blend::to_bits", "Cubic::to_bits",
            "FloatFrame::to_bits", "FloatRamp::to_bits", "Frame16::to_bits", "Frame32::to_bits",
            "Gain16::to_bits", "Gain32::to_bits", "Knot::to_bits", "Ramp32::to_bits",
        ],
    ),
    (
        "a macro of firmware/effects/src/raw.rs calls it, for each format",
        &[
            "Frame16::from_bits", "Frame32::from_bits", "Gain16::from_bits", "Gain32::from_bits",
            "Ramp16::from_bits", "Ramp32::from_bits",
        ],
    ),
    ("only a profile can give it an exponent, and all profiles are linked", &["Fraction::real_power"]),
];

#[rustfmt::skip]
pub(crate) const REGISTER: &[Held] = &[
    // From a position or a versine to the intensity.
    by("tests/accuracy.rs::f32_keeps_its_rows", &[
        "Falloff::at", "Cone::compile", "Cone::opengl", "Spot::compile", "CompiledSpot::falloff",
        "CompiledSpot::irradiance", "Scalar for f32", "Profile for Soft", "Profile for Hard",
        "Profile for Linear", "Profile for CutOff", "Profile for Smooth", "Profile for Blend",
        "Profile for Cubic", "Profile for Power", "Profile for Rim", "Profile for Table",
        "Profile for IntegerPower", "Profile for IntegerRim", "Profile for MixedPower", "Profile for MixedRim",
    ]),
    through("tests/accuracy.rs::f32_keeps_its_rows", &[
        "Falloff::toward", "Scalar::weight", "Light for CompiledSpot", "Light::arrive",
    ]),
    by("tests/accuracy.rs::fx32_keeps_its_rows", &["Scalar for Fx32"]),
    by("tests/accuracy.rs::fx16_keeps_its_rows", &["Scalar for Fx16"]),
    by("tests/exhaustive.rs::fx32_keeps_its_roundings_over_every_fraction", &[
        "Profile::compile", "Curve::intensity", "Scalar::ramp", "Scalar::rise",
    ]),
    through("tests/exhaustive.rs::fx32_keeps_its_roundings_over_every_fraction", &[
        "Fraction::complement", "Fraction::fine_product", "Fraction::product", "Fraction::scalar",
        "Fraction::smooth", "Fraction::blend", "Fraction::cubic", "Fraction::sample",
    ]),
    through("tests/half_a_code.rs::fx16_holds_every_cone_that_it_accepts", &[
        "Scalar::rounding", "Scalar::holds_coarsely", "Scalar::fine_ramp", "Offset::fine_ray", "Offset::is_below", "Offset::faces_far_away",
        "Fraction::lack", "Fraction::mixed", "Share::rounded",
    ]),
    through("tests/bright.rs::fx16_adds_half_a_code_at_most", &[
        "Scalar::fine_below", "Scalar::is_enough", "Attenuation::grows", "Ray::near", "Ray::squared_near",
        "Share::give", "Share::is_all", "Share::rest", "Share::share_of", "Share::smoothed",
    ]),
    through("tests/lamps.rs::lamps_light_many_points_as_each", &["Share::of_scalar"]),
    by("tests/domain.rs::points_on_the_axis_have_all_the_light", &["Spot::axis_in"]),
    through("tests/domain.rs::points_on_the_axis_have_all_the_light", &["Scalar::aim"]),
    by("tests/cones.rs::inner_at_outer_is_a_step", &["Fraction::step", "Cone::with_inner", "Cone::inner"]),
    by("tests/cones.rs::a_delimiter_changes_nothing_within", &["Cone::with_delimiter"]),
    by("tests/narrow.rs::steepness_is_the_largest_slope", &["Profile::steepness"]),
    by("tests/narrow.rs::fx16_holds_what_it_states", &["Cone::narrowest"]),

    // Operations of the seam.
    by("tests/operations.rs::scalars_keep_their_rows", &[
        "Scalar::times", "Scalar::minus", "Scalar::smooth", "Scalar::to_f32",
    ]),
    by("core/src/scalar.rs::conversion_rounds_and_saturates_as_the_crate_fixed_does", &[
        "Scalar::from_f32", "Scalar::length",
    ]),
    by("tests/operations.rs::gains_keep_their_rows", &[
        "Scalar::gain", "Gain::by", "Gain::plus", "Gain::inverse_capped", "Gain::fraction",
    ]),
    by("tests/operations.rs::light_keeps_its_rows", &[
        "Scalar::expose", "Scalar::filter", "Scalar::add_light", "Scalar::light_to_f32",
        "Scalar::light_to_gain", "Scalar::amplify", "Scalar::clip", "Exposure::factor", "Exposure::compile",
        "CompiledExposure::expose", "Ambient::compile", "Ambient::with_intensity", "Material::compile",
        "Material::with_ambient", "Material::with_emissive", "CompiledMaterial::glow", "Rgb::lit",
        "Rgb::filtered", "Rgb::plus",
    ]),
    by("tests/operations.rs::directions_keep_their_rows", &[
        "Scalar::axis", "Scalar::normal_unit", "Scalar::mirror", "Scalar::direction_between",
        "Scalar::incidence", "Scalar::versine_between", "Scalar::versine", "Scalar::power",
        "Falloff::versine",
    ]),
    by("tests/operations.rs::rays_keep_their_rows", &[
        "Scalar::offset", "Offset::facing", "Offset::faces_away", "Offset::squared_distance", "Offset::ray",
        "Ray::distance", "Ray::direction", "Ray::versine", "Ray::cosine", "Ray::expose", "Fraction::of",
    ]),

    // Set-up.
    by("tests/setup.rs::angles_keep_their_figures", &[
        "Angle::degrees", "Angle::radians", "Angle::to_degrees", "Angle::to_radians", "Angle::versine",
        "Angle::from_versine", "HalfAngle::degrees", "HalfAngle::radians", "HalfAngle::to_degrees",
        "HalfAngle::to_radians",
    ]),
    by("tests/setup.rs::profiles_keep_their_figures", &[
        "Profile::beam_versine", "Profile::field_versine", "Profile::integral",
    ]),
    by("tests/setup.rs::cones_keep_their_figures", &[
        "Cone::from_outer", "Cone::from_field", "Cone::from_beam", "Cone::beam", "Cone::field", "Cone::outer",
        "Cone::outer_versine", "Cone::lumens", "Cone::candela",
    ]),
    by("tests/setup.rs::two_angles_keep_their_figures", &[
        "Cone::from_beam_and_field", "Cone::from_beam_field_and_slope",
    ]),
    by("tests/tables.rs::a_stated_difference_is_what_a_dense_search_finds", &["Table::from_angles"]),
    by("tests/tables.rs::a_table_of_knots_is_written_as_source", &["Table::knots", "Table::of_knots", "Knot::to_bits"]),
    by("tests/tables.rs::every_bit_pattern_of_a_knot_has_an_answer", &["Knot::from_bits"]),
    through("tests/tables.rs::formats_keep_to_the_line_between_knots", &["Fraction::along"]),
    by("tests/setup.rs::point_lights_keep_their_flux", &["Point::lumens", "Point::candela"]),
    by("tests/setup.rs::inner_products_keep_their_figure", &["Vec3::dot"]),
    by("tests/two_angles.rs::edge_slopes_are_what_the_search_finds", &["Cone::edge_slopes"]),
    by("tests/setup.rs::axes_and_ranges_keep_their_figures", &[
        "Spot::between", "Spot::axis", "Spot::attenuation", "SmoothRange::range",
    ]),

    // The square that a spotlight projects.
    by("tests/projection.rs::places_keep_their_rows", &[
        "Projection::of", "Projection::turned", "Projection::compile", "CompiledProjection::place",
    ]),
    through("tests/projection.rs::places_keep_their_rows", &["Scalar::frame", "Scalar::place"]),
    by("tests/projection.rs::a_frame_is_square", &["Projection::right", "Projection::up", "Projection::axis"]),
    by("tests/projection.rs::tangents_keep_their_figure", &["Projection::tangent"]),
    by("tests/projection.rs::what_no_square_can_be", &["Projection::position"]),
    by("tests/projection.rs::every_bit_pattern_has_a_place", &[
        "CompiledProjection::from_parts", "FloatFrame::from_bits", "Frame16::from_bits", "Frame32::from_bits",
        "Place::is_inside",
    ]),

    // Patterns on it.
    by("tests/gobo.rs::transmissions_keep_their_rows", &[
        "Gobo::new", "Gobo::on", "Gobo::transmission", "CompiledGobo::at",
    ]),
    by("tests/gobo.rs::weighted_bytes_keep_their_roundings", &["Scalar::weighted_byte"]),
    by("tests/gobo.rs::clear_glass_changes_no_bit", &["CompiledGobo::filter"]),
    by("tests/gobo.rs::a_gobo_keeps_what_it_is_given", &[
        "Gobo::of", "Gobo::side", "Gobo::transmissions", "CompiledGobo::from_parts", "CompiledGobo::gobo",
        "CompiledGobo::projection",
    ]),

    // Shadows on it.
    by("tests/shadow.rs::visibilities_keep_their_row", &["Shadow::new", "Shadow::at", "Scalar::part"]),
    by("tests/shadow.rs::a_point_has_the_visibility_of_its_place", &["Shadow::visibility"]),
    by("tests/shadow.rs::any_bits_have_a_visibility", &["Shadow::from_parts"]),
    by("tests/shadow.rs::a_shadow_keeps_what_it_is_given", &["Shadow::projection", "Shadow::side", "Shadow::depths"]),

    // Distance, highlight and the lit point.
    by("tests/lit.rs::no_fall_keeps_its_row", &[
        "Attenuation for Unattenuated", "Attenuation::expose", "Point::compile", "Point::with_attenuation",
        "CompiledPoint::irradiance",
    ]),
    through("tests/lit.rs::no_fall_keeps_its_row", &["Attenuation::constants", "Light for CompiledPoint"]),
    by("tests/lit.rs::inverse_square_keeps_its_row", &["Attenuation for InverseSquare"]),
    by("tests/lit.rs::polynomial_keeps_its_row", &["Attenuation for Polynomial", "Polynomial::new"]),
    by("tests/lit.rs::smooth_range_keeps_its_row", &["Attenuation for SmoothRange", "SmoothRange::new"]),
    by("tests/lit.rs::windowed_keeps_its_row", &["Attenuation for Windowed", "Windowed::new"]),
    by("tests/lit.rs::squared_window_keeps_its_row", &[
        "Attenuation for SquaredWindow", "SquaredWindow::new",
    ]),
    by("tests/lit.rs::a_cut_is_a_cut", &["Attenuation for HardRange", "HardRange::new"]),
    through("tests/lit.rs::a_cut_is_a_cut", &["Attenuation::is_beyond"]),
    through("tests/haze.rs::every_cone_keeps_its_row", &["Attenuation::is_inverse_square"]),
    by("tests/lit.rs::phong_keeps_its_rows", &[
        "Highlight for Phong", "Highlight::directions", "Specular for H", "Specular::constants",
        "Specular::lobe",
    ]),
    by("tests/lit.rs::blinn_phong_keeps_its_rows", &["Highlight for BlinnPhong"]),
    by("tests/lit.rs::dual_cone_keeps_its_rows", &["Highlight for DualCone"]),
    by("tests/lit.rs::a_highlight_ends_where_it_says", &["Specular::end"]),
    by("tests/lit.rs::lyon_keeps_its_rows", &["Specular for Lyon"]),
    by("tests/lit.rs::the_lit_point_keeps_its_rows", &[
        "Material::new", "Material::with_highlight", "Ambient::new", "Spot::new", "Surface::seen_from",
        "CompiledMaterial::reflect", "emission_methods!::with_color",
        "emission_methods!::with_specular_color", "emission_methods!::with_intensity",
    ]),
    by("tests/operations.rs::parallel_light_keeps_its_row", &[
        "Directional::new", "Directional::compile", "Directional::direction",
        "CompiledDirectional::irradiance",
    ]),
    through("tests/operations.rs::parallel_light_keeps_its_row", &["Light for CompiledDirectional"]),

    // Lights that are chosen at run time, and the plan of a picture.
    by("tests/lamps.rs::lamps_light_many_points_as_each", &[
        "CompiledLamp::arrive_each", "Lamp::compile", "Light for CompiledLamp", "Surfaces::at",
    ]),
    by("tests/lamps.rs::beams_show_in_many_rays_as_in_each", &[
        "CompiledLamp::in_haze", "HazyBeam::air_light_each", "HazyBeam::air_light_through_each", "ViewRays::at",
    ]),
    by("tests/lamps.rs::a_lamp_calls_for_what_it_is", &["Lamp::effects", "Lamp::intensity", "Luminaire::lamp"]),
    by("tests/lamps.rs::lamps_without_a_range_have_none", &[
        "Distance::range", "Cone::has_hotspot", "Cone::is_delimited",
    ]),
    by("tests/lamps.rs::a_dark_lamp_is_dropped", &[
        "Lamp::is_dark", "Luminaire::effects", "Plan::with_luminaire", "Plan::prepare", "Plan::everything",
    ]),
    through("tests/lamps.rs::a_dark_lamp_is_dropped", &["Lamp::color", "Lamp::specular_color"]),
    by("tests/lamps.rs::a_plan_calls_for_what_it_was_given", &[
        "Plan::new", "Plan::with", "Plan::with_ambient", "Plan::with_material", "Plan::effects",
        "Plan::calls_for", "Plan::skips",
    ]),
    by("tests/lamps.rs::effects_are_a_set", &["Effects::with", "Effects::and", "Effects::has", "Effects::iter"]),
    by("tests/lamps.rs::a_shadow_map_has_a_side_that_can_be", &["Luminaire::with_shadow", "Luminaire::shadow"]),
    by("tests/lamps.rs::what_projects_no_square_is_refused", &[
        "Luminaire::with_gobo", "Luminaire::gobo", "Luminaire::compile_gobo",
    ]),
    // Haze.
    by("tests/haze.rs::every_cone_keeps_its_row", &["HazyBeam::air_light", "CompiledSpot::in_haze"]),
    by("tests/haze.rs::samples_keep_their_rows", &["HazyBeam::air_light_through"]),
    by("tests/haze_laws.rs::no_bundle_with_a_lit_ray_is_rejected", &[
        "HazyBeam::can_meet", "ViewBundle::around",
    ]),
    by("tests/haze_laws.rs::a_ray_between_two_points_has_their_direction_and_distance", &[
        "ViewRay::between", "ViewRay::endless",
    ]),
    by("tests/haze_laws.rs::any_bits_have_an_air_light", &["HazyBeam::from_parts"]),
    by("tests/haze_laws.rs::haze_keeps_what_it_is_given", &[
        "Haze::new", "Haze::with_lamp_radius", "Haze::density", "Haze::lamp_radius",
    ]),

    // What is only stored.
    by("tests/kept.rs::lights_keep_what_they_are_given", &[
        "Ambient::color", "Ambient::intensity", "Point::new", "Point::position", "Point::attenuation",
        "Spot::position", "Spot::cone", "Spot::with_axis", "Spot::with_cone", "Spot::with_attenuation",
        "emission_methods!::color", "emission_methods!::specular_color", "emission_methods!::intensity",
    ]),
    by("tests/kept.rs::compiled_lights_keep_their_colors", &[
        "CompiledSpot::color", "CompiledSpot::specular_color", "CompiledSpot::profile", "Light::color",
        "Light::specular_color", "Surface::matte",
    ]),
    by("tests/kept.rs::materials_keep_what_they_are_given", &[
        "Material::ambient", "Material::diffuse", "Material::emissive", "Material::specular",
        "Material::shininess",
    ]),
    by("tests/kept.rs::distances_keep_what_they_are_given", &[
        "Polynomial::coefficients", "Windowed::range", "SquaredWindow::range", "HardRange::range",
        "HardRange::attenuation", "Faded::new", "Faded::attenuation", "Faded::range",
    ]),
    by("tests/kept.rs::profiles_keep_what_they_are_given", &[
        "IntegerPower::new", "IntegerPower::exponent", "IntegerRim::new", "IntegerRim::exponent",
        "MixedPower::new", "MixedPower::exponents", "MixedPower::share", "MixedRim::new",
        "MixedRim::exponents", "MixedRim::share", "RealPower::new", "RealPower::exponent", "RealRim::new", "RealRim::exponent",
        "RealRim::floor", "Blend::new", "Blend::edge_slope", "Cubic::new", "Cubic::with_slopes", "Cubic::coefficients",
        "Cubic::edge_slope", "Cubic::middle_slope", "Table::new", "Table::samples", "Cone::profile",
        "Falloff::profile", "Falloff::with_profile",
    ]),
    by("tests/kept.rs::components_stay_in_their_places", &[
        "Vec3::new", "Vec3::map", "Vec3::zip", "Rgb::new", "Rgb::map", "Rgb::zip",
    ]),

    // The lights of other systems.
    by("tests/import.rs::compiled_lights_are_the_originals", &[
        "OpenGl::import", "Direct3d::import", "Gltf::import", "Three::import", "Godot::import", "Penumbra::import",
        "Difference::most",
    ]),
    by("tests/import.rs::gltf_as_recommended_is_the_reference_code", &["Gltf::import_as_recommended"]),
    through("tests/import.rs::compiled_lights_are_the_originals", &["Attenuation for Distance"]),
    by("tests/powers.rs::real_powers_keep_their_rows", &["Profile for RealPower", "Profile for RealRim"]),
    through("tests/powers.rs::real_powers_keep_their_rows", &["Fraction::real_power"]),
    by("tests/import.rs::a_matched_profile_changes_no_bit", &["Profile for Matched"]),

    // Many at once.
    by("tests/batch.rs::spots_light_a_batch_as_they_light_a_point_in_f32", &[
        "batch_methods!::irradiance_each", "batch_methods!::add_each",
    ]),
    through("tests/batch.rs::spots_light_a_batch_as_they_light_a_point_in_f32", &[
        "Offset::reciprocal", "Offset::ray_of", "Ray::rise",
    ]),
    by("tests/batch.rs::a_falloff_of_many_versines_is_that_of_each", &["Falloff::at_each"]),

    // Constants from raw bits.
    by("tests/generated.rs::a_generated_constant_has_the_bits_of_the_compiled_value", &["Source::as_source"]),
    through("tests/generated.rs::a_generated_constant_has_the_bits_of_the_compiled_value", &[
        "Source::write", "Named::write_name", "Blend::to_bits", "Cubic::to_bits", "FloatRamp::to_bits",
        "FloatFrame::to_bits", "Frame16::to_bits", "Frame32::to_bits", "Gain16::to_bits", "Gain32::to_bits", "Ramp16::to_bits", "Ramp32::to_bits", "Table::of",
    ]),
    by("tests/any_bits.rs::any_bits_make_a_light_in_fx16", &[
        "Blend::from_bits", "Cubic::from_bits", "CompiledBlend::from_parts", "CompiledCubic::from_parts",
        "CompiledDirectional::from_parts", "CompiledExposure::from_parts", "CompiledMaterial::from_parts",
        "CompiledPoint::from_parts", "CompiledSpot::from_parts", "Falloff::from_parts",
        "FloatRamp::from_bits", "Gain16::from_bits", "Gain32::from_bits", "Ramp16::from_bits",
        "Ramp32::from_bits",
    ]),

    // The display.
    by("tests/display.rs::every_threshold_is_exact", &["encode_srgb"]),
    by("tests/display.rs::sixteen_bits_are_encoded_exactly", &["Rgb565::from_linear"]),
    through("tests/display.rs::sixteen_bits_are_encoded_exactly", &["Scalar::srgb"]),
    by("tests/display.rs::every_code_comes_back", &["decode_srgb"]),
    by("tests/display.rs::pixels_are_the_nearest", &["Rgb565::from_codes", "Rgb565::to_codes"]),
    by("tests/display.rs::light_past_full_scale_follows_the_stated_policy", &["clip", "keep_hue"]),
    by("tests/display.rs::stops_double_and_halve", &["Exposure::stops"]),
    by("tests/dither.rs::sixteen_bits_keep_the_light_of_a_cell", &[
        "encode_srgb_dithered", "Rgb565::from_linear_dithered",
    ]),
    through("tests/dither.rs::sixteen_bits_keep_the_light_of_a_cell", &["Scalar::srgb_dithered"]),

    // The same bits another way.
    by("tests/equivalence.rs::skipping_is_exact_in_fx16", &["CompiledSpot::irradiance_unskipped"]),
    through("tests/equivalence.rs::skipping_is_exact_in_fx16", &["Offset::is_outside"]),
    by("tests/lights.rs::every_bit_pattern_has_an_answer_in_fx16", &[
        "CompiledMaterial::reflect_unskipped", "Specular for Matte",
    ]),
    by("tests/lights.rs::no_light_is_made_next_to_a_lamp", &["CompiledPoint::irradiance_unskipped"]),
    by("tests/equivalence.rs::a_choice_at_run_time_changes_no_bit", &[
        "Profile for Edge", "CompiledSpot::with_profile",
    ]),
    by("tests/equivalence.rs::a_fitted_profile_changes_no_bit", &[
        "Profile for Fitted", "Cone::with_profile",
    ]),
];
