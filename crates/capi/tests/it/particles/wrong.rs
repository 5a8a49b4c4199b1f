//! Wrong input: each is named, and nothing is changed.

use super::*;

#[test]
fn laws_that_cannot_be_are_named() {
    let usual = options(0);
    let soft = CaromMaterial { poisson: 0.7, ..GLASS };
    let rigid = CaromMaterial { young_modulus: f64::INFINITY, ..GLASS };
    for ([one, two], friction, its, words) in [
        ([soft, GLASS], 0.1, usual, "poisson = 0.7"),
        ([GLASS; 2], -0.1, usual, "friction = -0.1"),
        ([GLASS; 2], f64::INFINITY, usual, "friction = inf"),
        ([GLASS; 2], 0.1, CaromLawOptions { law: 3, ..usual }, "law = 3"),
        ([GLASS; 2], 0.1, CaromLawOptions { relaxation: -1.0, ..usual }, "relaxation = -1"),
        ([GLASS; 2], 0.1, CaromLawOptions { relaxation: -1.0, ..options(2) }, "relaxation = -1"),
        ([GLASS; 2], 0.1, CaromLawOptions { tolerance: 2.0, ..usual }, "tolerance = 2"),
        ([GLASS; 2], 0.1, CaromLawOptions { tolerance: 2.0, ..options(2) }, "tolerance = 2"),
        ([GLASS; 2], 0.1, CaromLawOptions { size: 4, ..usual }, "size = 4"),
        ([GLASS; 2], 0.1, CaromLawOptions { size: 1 << 20, ..usual }, "size = 1048576"),
        ([rigid; 2], 0.1, usual, "shear_modulus"),
    ] {
        let told = Made::new([one, two], friction, &its).err().unwrap();
        assert_eq!(told.status, CaromStatus::OutOfRange, "{}", told.text);
        assert!(told.text.contains(words), "{}", told.text);
    }
    // Of a caller with fewer fields the others are what is usual, and so are all without options.
    let old = CaromLawOptions { size: 8, law: 77, torsion: 9, ..usual };
    let law = Made::new([GLASS; 2], 0.1, &old).unwrap();
    // SAFETY: all pointers are references or null.
    let made = told(null_mut(), |law, error| unsafe {
        carom_law_make(&GLASS, &GLASS, 0.1, null(), law, error)
    });
    let other = Made(made.unwrap());
    assert_eq!(law.touch(), other.touch());
    let told = told(null_mut::<CaromLaw>(), |_, error| {
        // SAFETY: null is told.
        unsafe { carom_law_make(&GLASS, &GLASS, 0.1, null(), null_mut(), error) }
    });
    assert_eq!(told.unwrap_err().field, "law");
    // SAFETY: null is allowed.
    unsafe { carom_law_free(null_mut()) };
}

#[test]
fn laws_have_names() {
    for (law, name) in LAWS.into_iter().zip([c"coulomb", c"fixed-direction", c"rings"]) {
        // SAFETY: texts that end with a zero.
        unsafe {
            assert_eq!(CStr::from_ptr(carom_law_name(law)), name);
            let known = told(7, |to, error| carom_law_of_name(name.as_ptr(), to, error));
            assert_eq!(known, Ok(law));
        }
    }
    // SAFETY: texts that end with a zero.
    unsafe {
        assert_eq!(CStr::from_ptr(carom_law_name(3)), c"");
        let told = told(7, |to, error| carom_law_of_name(c"ring".as_ptr(), to, error));
        let told = told.unwrap_err();
        assert_eq!((told.status, told.field.as_str()), (CaromStatus::OutOfRange, "law"));
        assert!(told.text.contains("did you mean \"rings\""), "{}", told.text);
        assert_eq!(carom_law_of_name(null(), &mut 0, null_mut()), CaromStatus::NullPointer);
    }
}

/// Of every kind of law, before the bodies touch and in contact.
#[test]
fn a_failed_step_leaves_the_touch_as_it_was() {
    for its in LAWS {
        let plain = options(its);
        for its in [plain, CaromLawOptions { torsion: 1, rolling: ROLLING, ..plain }] {
            let law = Made::new([GLASS; 2], 0.1, &its).unwrap();
            let still = |place| grain(place, [0.0; 3], [0.0; 3], 1.0);
            let (one, near) = (still([0.0; 3]), still([0.0, 0.0, 1.99]));
            let mut touch = law.touch();
            touch.step(&law, &one, &Second::Grain(near), 1e-3);
            for touch in [law.touch(), touch] {
                for (two, dt, field) in [
                    (one, 1.0, "distance"),
                    (CaromGrain { radius: -1.0, ..near }, 1.0, "radius_2"),
                    (CaromGrain { place: [f64::NAN; 3], ..near }, 1.0, ""),
                    (CaromGrain { velocity: [0.0, 1e200, 0.0], ..near }, 1.0, ""),
                    (CaromGrain { spin: [1e200, 0.0, 1e200], ..near }, 1.0, ""),
                    (near, f64::NAN, ""),
                ] {
                    // A contact with a law of shifts does not ask for radii again.
                    if field == "radius_2"
                        && !touch.is_new()
                        && its.rolling.friction == 0.0
                        && its.law < 2
                    {
                        continue;
                    }
                    let (mut same, mut heats) = (touch.clone(), CaromHeats::default());
                    for sums in [None, Some(&mut heats)] {
                        let told = same.tried(&law, (&one, &Second::Grain(two)), dt, sums);
                        let told = told.unwrap_err();
                        assert_eq!(told.status, CaromStatus::OutOfRange, "{its:?} {}", told.text);
                        assert!(field.is_empty() || told.field == field, "{}", told.text);
                        assert!(!told.field.is_empty() && told.text.contains("is out of range"));
                        assert_eq!(same, touch, "{}", told.text);
                    }
                    assert_eq!(heats, CaromHeats::default());
                }
            }
        }
    }
}

/// An axis of no length, along the normal or no number; a normal of another length.
#[test]
fn a_wall_that_is_none_is_refused() {
    let law = Made::new([GLASS; 2], 0.1, &options(0)).unwrap();
    let one = grain([0.0, 0.0, 0.999], [0.0; 3], [0.0; 3], 1.0);
    for axis in [[0.9, 0.0, 0.0], [0.0, 0.0, 1.0], [f64::NAN, 0.0, 0.0]] {
        let on = wall([0.0; 3], [0.0; 3], axis);
        let told = law.touch().tried(&law, (&one, &on), 1e-6, None).unwrap_err();
        assert_eq!((told.status, told.field.as_str()), (CaromStatus::OutOfRange, "axis"));
    }
    let Second::Wall(on) = wall([0.0; 3], [0.0; 3], [0.0; 3]) else { unreachable!() };
    let leaning = Second::Wall(CaromSurface { normal: [0.0, 0.1, 1.0], ..on });
    let told = law.touch().tried(&law, (&one, &leaning), 1e-6, None).unwrap_err();
    assert_eq!(told.field, "normal");
    // Infinitely far inside a wall there is no load.
    let inside = CaromGrain { place: [0.0; 3], radius: f64::INFINITY, ..one };
    let told = law.touch().load(&law, &inside, &Second::Wall(on)).unwrap_err();
    assert_eq!(told.status, CaromStatus::OutOfRange);
}

#[test]
fn pointers_are_checked_before_anything_moves() {
    let law = Made::new([GLASS; 2], 0.1, &options(0)).unwrap();
    let one = grain([0.0, 0.0, 1.99], [0.0; 3], [0.0; 3], 1.0);
    let two = grain([0.0; 3], [0.0; 3], [0.0; 3], 1.0);
    let Second::Wall(on) = wall([0.0; 3], [0.0; 3], [0.0; 3]) else { unreachable!() };
    let mut touch = law.touch();
    let mut load = CaromGrainLoad::default();
    let (at, to, none) = (touch.place(), &raw mut load, null_mut());
    let odd = to.wrapping_byte_add(4);
    for (law, touch, one, (two, wall), load, field) in [
        (null(), at, &raw const one, (&raw const two, null()), to, "law"),
        (law.0.cast_const(), null_mut(), &raw const one, (&raw const two, null()), to, "touch"),
        (law.0, at.wrapping_byte_add(4), &raw const one, (&raw const two, null()), to, "touch"),
        (law.0, at, null(), (&raw const two, null()), to, "one"),
        (law.0, at, &raw const one, (null(), null()), to, "two"),
        (law.0, at, &raw const one, (&raw const two, &raw const on), to, "wall"),
        (law.0, at, &raw const one, (&raw const two, null()), null_mut(), "load"),
        (law.0, at, &raw const one, (&raw const two, null()), odd, "load"),
    ] {
        // SAFETY: all pointers are references, null or misaligned.
        let told = told((), |(), error| unsafe {
            carom_touch_step(law, touch, one, two, wall, 1e-3, load, none, error)
        });
        assert_eq!(told.unwrap_err().field, field);
    }
    assert_eq!((touch.is_new(), load), (true, CaromGrainLoad::default()));
}

/// A touch of another law, of another build, or that the numbers of no contact are.
#[test]
fn what_does_not_belong_together_is_refused() {
    let kinds = [
        options(CAROM_LAW_COULOMB),
        options(CAROM_LAW_RINGS),
        CaromLawOptions { torsion: 1, ..options(0) },
        CaromLawOptions { rolling: ROLLING, ..options(0) },
        CaromLawOptions { torsion: 1, rolling: ROLLING, ..options(1) },
    ];
    let laws = kinds.map(|its| Made::new([GLASS, STEEL], 0.15, &its).unwrap());
    let one = grain([0.0, 0.0, 1.99], [0.0; 3], [0.0; 3], 1.0);
    let two = Second::Grain(grain([0.0; 3], [0.0; 3], [0.0; 3], 1.0));
    let touches = laws.each_ref().map(|law| {
        let mut touch = law.touch();
        touch.step(law, &one, &two, 1e-3);
        touch.words.resize(700, 0);
        touch
    });
    for (i, law) in laws.iter().enumerate() {
        for (k, touch) in touches.iter().enumerate() {
            let mut same = touch.clone();
            let status = same.tried(law, (&one, &two), 1e-3, None).map_err(|told| told.status);
            assert_eq!(status.is_ok(), i == k, "{i} {k} {status:?}");
            assert!(i == k || (status == Err(CaromStatus::BadState) && same == *touch));
        }
        for mark in [5, 1 << 33, 2 << 33, 3 << 33] {
            let mut strange = touches[i].clone();
            strange.words[0] = mark;
            let told = strange.tried(law, (&one, &two), 1e-3, None).unwrap_err();
            assert_eq!((told.status, told.field.as_str()), (CaromStatus::BadState, "touch"));
        }
        let mut numbers = laws[i].touch().packed(law);
        numbers[0] = 7.0;
        let told = Touch::unpacked(law, [1.0; 2], &numbers).unwrap_err();
        assert_eq!((told.status, told.field.as_str()), (CaromStatus::BadState, "mark"));
    }
}
