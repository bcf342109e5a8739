mod formulas;
#[test]
fn x() {
    for f in formulas::FORMULAS {
        println!("{} {}", f.0, f.1(&[], formulas::Kind::Spot, 0.1, 2.0));
    }
}
