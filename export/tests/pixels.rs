mod support;
#[test]
fn dump() {
    std::fs::create_dir_all("/tmp/cd").unwrap();
    std::fs::write("/tmp/cd/luminaire.h", luminaire_export::c_header() + &luminaire_export::c_pixels()).unwrap();
    std::fs::write("/tmp/cd/luminaire_display.h", luminaire_export::c_display_header()).unwrap();
}
