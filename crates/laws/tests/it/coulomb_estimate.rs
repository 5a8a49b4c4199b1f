//! The error of Coulomb's law in two directions, compared with independent annuli of sliders, and
//! its own estimate of that error.

use carom_drawn::{Draw as _, Splitmix};
use carom_laws::coulomb::{CoulombMemory, FixedCurve, Tolerance};
use carom_laws::memory::{Fixed, Growing, VertexStack};
use proptest::prelude::*;

use crate::common;
use crate::common::rings::force_at_end;
use crate::common::turning::{Kind, divided};

type Point = (f64, [f64; 2]);

/// The error over the limit at the end of a path, and its estimate.
fn error<S: VertexStack<[f64; 2]>>(path: &[Point], tolerance: f64, want: [f64; 2]) -> [f64; 2] {
    let mut law = CoulombMemory::<[f64; 2], S::Curve>::new(Tolerance::new(tolerance).unwrap());
    for &(zeta, x) in path {
        law.advance(zeta, x).unwrap();
    }
    let (force, limit) = (law.force(), law.normal_force());
    let error = (force[0] / limit - want[0]).hypot(force[1] / limit - want[1]);
    [error, law.error_estimate()]
}

/// The errors and their estimates in storage that grows and in 8, 12, 16 and 32 vertices.
fn errors(path: &[Point], tolerance: f64, rings: usize) -> [[f64; 2]; 5] {
    let want = force_at_end(path, rings);
    let found = [
        error::<Growing<[f64; 2]>>(path, tolerance, want),
        error::<Fixed<[f64; 2], 8>>(path, tolerance, want),
        error::<Fixed<[f64; 2], 12>>(path, tolerance, want),
        error::<Fixed<[f64; 2], 16>>(path, tolerance, want),
        error::<Fixed<[f64; 2], 32>>(path, tolerance, want),
    ];
    println!("{tolerance:e}: {found:?}");
    found
}

/// The error of that many rings.
fn of_rings(rings: usize) -> f64 {
    2.0 / (rings * rings) as f64
}

/// Seven points after which twelve vertices were once full, a piece was drawn though its bubble was
/// too large, and nothing told: off by 2.4e-2 at any tolerance.
const FULL: [Point; 7] = [
    (0.519_834_119_660_948_1, [-0.364_248_516_131_835_34, 0.383_021_780_916_246_7]),
    (0.501_859_141_046_434_4, [-0.211_971_174_772_783_27, 0.225_415_779_902_282_54]),
    (0.481_803_250_769_094_9, [0.057_520_499_336_227_16, 0.545_001_617_048_593_6]),
    (0.076_165_688_732_125_81, [0.099_630_333_369_021_83, 0.168_546_586_761_135_15]),
    (0.823_213_679_607_774_3, [-0.531_388_099_916_64, 0.597_131_457_944_521_3]),
    (0.580_438_100_355_597_1, [0.116_062_339_060_570_06, 0.680_977_961_892_425_3]),
    (0.500_636_272_635_201, [0.165_972_487_164_601_8, 0.520_964_014_330_528_7]),
];

/// Four points after which a step along the cone slips near the rim alone: once off by 7.9e-5 at
/// tolerances of 1e-4 and of 1e-5 alike.
const BAND: [Point; 4] = [
    (1.0, [0.0, 0.0]),
    (1.013_179_048_707_484_3, [-0.529_808_232_267_305_4, 0.278_851_388_503_794_3]),
    (1.035_395_741_568_396_3, [-1.465_779_173_104_520_7, 0.644_931_797_563_154_3]),
    (0.232_158_909_602_856_68, [-0.726_913_198_531_290_8, 0.329_774_294_832_096_97]),
];

/// Fourteen points on which a piece whose tractions turn to and fro was drawn as one parabola: once off by
/// 1.26e-2 at 1e-2.
const FINE_BUT_OFF: [Point; 14] = [
    (1.0, [0.0, 0.0]),
    (0.920_039_657_859_135, [-0.409_119_747_544_217_87, 0.219_106_681_589_265_72]),
    (1.086_695_711_839_602_1, [-0.902_609_304_957_459_8, 0.417_061_761_173_732_06]),
    (1.357_118_408_520_982_2, [-1.283_744_686_918_482_3, 0.751_292_124_734_957_3]),
    (1.5, [-0.951_512_404_880_833_2, 1.118_435_244_349_890_2]),
    (1.474_261_567_368_259, [-1.035_861_235_484_390_4, 0.856_211_651_508_398_4]),
    (1.5, [-0.590_437_179_697_463_5, 1.368_566_538_211_207_6]),
    (1.301_122_747_978_426_6, [-1.263_027_301_126_776, 2.037_361_697_880_164_5]),
    (1.344_274_188_543_778_6, [-0.443_782_189_825_103_1, 1.770_335_466_793_154_8]),
    (1.343_475_550_418_358_6, [-0.076_855_163_338_957_48, 0.872_943_620_631_086_4]),
    (1.283_157_727_565_934_5, [-0.134_803_353_956_198_8, 1.227_134_059_595_189_6]),
    (1.294_384_705_157_138, [-0.072_822_882_681_881_54, 1.030_270_605_738_718_8]),
    (0.730_201_670_435_034_9, [-0.257_086_931_504_075_97, 0.362_842_404_540_705_15]),
    (0.232_958_682_251_050_54, [-0.485_697_883_345_724_17, 0.809_100_787_708_449_4]),
];

/// Twelve points found by climbing, after which twelve vertices were once off by 6.5e-2.
const FULL_LONG: [Point; 12] = [
    (1.0, [0.0, 0.0]),
    (0.640_372_820_300_480_8, [0.438_848_672_439_416_1, -0.239_379_178_671_637_5]),
    (0.566_003_736_721_884_9, [0.458_286_854_557_468_5, -0.644_150_610_002_596_4]),
    (0.362_237_460_452_435_9, [0.236_004_375_425_182_77, -0.232_833_380_258_635_31]),
    (0.081_080_657_219_839_37, [0.459_414_888_999_839, -0.031_435_721_922_437_626]),
    (0.068_466_203_787_668_77, [0.316_322_630_636_959_3, -0.288_975_518_713_339_5]),
    (0.053_717_456_026_806_394, [0.260_551_055_378_622, -0.142_249_313_017_916_35]),
    (0.293_302_244_756_683_76, [0.157_809_693_734_895, -0.435_705_075_580_663_96]),
    (0.296_386_540_747_225_76, [0.452_016_940_632_149_64, -0.349_382_284_340_384_9]),
    (0.291_953_009_598_391, [0.460_875_212_987_275_13, -0.074_015_391_500_303_62]),
    (0.173_639_965_014_481_7, [0.357_554_181_124_783_2, -0.270_012_842_695_646_46]),
    (0.134_528_293_738_685_13, [0.326_861_396_017_249_73, -0.245_210_196_280_201_4]),
];

/// Twelve points found by climbing: a long slide leaves a traction across it that decays within a piece, once
/// drawn as a parabola and off by 4.5 times the estimate at 1e-5.
const DECAYING: [Point; 12] = [
    (0.049_704_612_4, [-0.700_584_194, -1.435_619_05]),
    (0.368_879_811, [-1.480_381_7, -1.439_719_89]),
    (0.908_883_918, [-0.436_925_692, -1.446_250_15]),
    (0.674_089_232, [-0.701_510_27, -1.432_493_22]),
    (0.125_361_552, [-0.700_843_793, -1.434_406_7]),
    (0.204_860_167, [-1.480_381_7, -1.431_563_9]),
    (0.161_205_775, [-1.146_353, 0.655_449_961]),
    (0.302_714_125, [-0.756_843_902, -1.112_894_36]),
    (0.680_252_369, [-0.857_822_131, -1.195_189_89]),
    (0.186_513_152, [-0.825_149_804, -1.094_300_95]),
    (0.798_427_441, [-0.782_635_243, -1.033_247_69]),
    (0.077_924_909_9, [-0.816_360_309, -0.982_425_285]),
];

/// Fourteen points found by climbing: rings meet their limits late in a step, and the bubble of their piece grows;
/// once off by 2.8 times the estimate at 1e-5.
const GROWN: [Point; 14] = [
    (0.050_185_129_7, [0.494_915_781, -0.847_194_382]),
    (0.002_564_149_83, [-0.140_725_412, -0.704_300_463]),
    (0.839_583_909, [-0.140_725_412, -0.704_300_463]),
    (0.079_363_364_6, [-0.737_136_484, 0.206_145_648]),
    (0.001, [0.490_107_573, -0.822_315_451]),
    (0.789_717_025, [-0.140_660_194, -0.704_379_256]),
    (0.775_858_086, [-0.161_362_142, -0.390_087_464]),
    (0.947_619_202, [-0.146_958_308, -0.341_492_945]),
    (0.898_674_828, [-0.161_190_82, -0.390_005_955]),
    (0.890_953_42, [-0.145_360_656, -0.707_241_137]),
    (0.890_953_42, [0.489_289_392, -0.821_684_03]),
    (0.839_181_563, [0.476_464_825, -0.827_169_743]),
    (0.839_181_563, [0.490_832_514, -0.822_440_371]),
    (0.033_713_7, [0.490_832_514, -0.822_440_371]),
];

/// The same in seven points and twelve vertices, once off by 11 times the estimate at 1e-5.
const GROWN_IN_TWELVE: [Point; 7] = [
    (1.019_223_86, [-0.102_867_505, -0.031_694_329_7]),
    (0.453_529_627, [-0.112_043_713, 0.105_727_578]),
    (1.493_837_49, [-1.253_381_5, 0.776_514_468]),
    (1.493_837_49, [-1.195_114_8, 0.654_325_869]),
    (1.395_979_8, [-0.112_043_713, 0.105_727_578]),
    (0.093_376_355_9, [-0.057_287_22, 0.027_615_463_4]),
    (0.084_063_874_4, [-0.057_084_200_7, 0.027_765_688_8]),
];

/// Asserts that no error exceeds its estimate; the errors.
#[track_caller]
fn within_estimates(path: &[Point], tolerance: f64, rings: usize) -> [f64; 5] {
    errors(path, tolerance, rings).map(|[error, estimate]| {
        let allowed = estimate + of_rings(rings);
        assert!(error <= allowed, "{error:e} beyond {estimate:e} at {tolerance:e}");
        error
    })
}

#[test]
fn full_storage_makes_room_before_a_piece_is_drawn() {
    for path in [&FULL[..], &FULL_LONG] {
        for tolerance in [1e-2, 1e-3, 1e-5] {
            let [growing, eight, twelve, sixteen, more] = within_estimates(path, tolerance, 12_000);
            assert!(growing < tolerance && eight < 3e-3 && twelve < 1e-3);
            assert!(sixteen < 1e-3 && more < 1e-3);
        }
    }
}

#[test]
fn slip_in_a_thin_band_is_found() {
    let [growing, ..] = within_estimates(&BAND, 1e-5, 40_000);
    assert!(growing < 1e-5);
    let [growing, ..] = within_estimates(&BAND, 1e-4, 40_000);
    assert!(growing < 1e-4);
}

#[test]
fn a_piece_that_winds_about_its_parabola_is_split() {
    for (tolerance, largest) in [(1e-2, 1e-2), (1e-3, 1e-4)] {
        let [growing, ..] = within_estimates(&FINE_BUT_OFF, tolerance, 12_000);
        assert!(growing < largest);
    }
}

#[test]
fn what_climbs_found_is_within_the_estimates() {
    for tolerance in [1e-2, 1e-3, 1e-5] {
        within_estimates(&DECAYING, tolerance, 12_000);
        within_estimates(&GROWN, tolerance, 12_000);
        within_estimates(&GROWN_IN_TWELVE, tolerance, 12_000);
    }
    let [growing, ..] = within_estimates(&DECAYING, 1e-5, 40_000);
    assert!(growing < 2e-6);
}

#[test]
fn a_tighter_tolerance_is_no_worse_in_fixed_storage() {
    for path in [&FULL[..], &FULL_LONG, &FINE_BUT_OFF] {
        let [_, coarse @ ..] = errors(path, 1e-2, 4000).map(|[error, _]| error);
        for tolerance in [1e-3, 1e-4, 1e-5] {
            let [_, fine @ ..] = errors(path, tolerance, 4000).map(|[error, _]| error);
            for (fine, coarse) in fine.into_iter().zip(coarse) {
                assert!(fine <= 2.0 * coarse + 1e-3, "{tolerance:e}: {fine:e} {coarse:e}");
            }
        }
    }
}

/// Storage of 64 vertices, that of arrays of contacts, on paths that turn at will.
#[test]
fn a_tolerance_beyond_what_storage_holds_is_no_worse() {
    for seed in 0..20 {
        let path = Kind::Noise.path(&mut Splitmix(seed));
        let mut exact = CoulombMemory::<[f64; 2]>::new(Tolerance::new(1e-9).unwrap());
        let tolerances = [1e-4, 1e-6, 1e-7, 1e-9].map(|own| Tolerance::new(own).unwrap());
        let mut laws = tolerances.map(CoulombMemory::<[f64; 2], FixedCurve<[f64; 2], 64>>::new);
        for (zeta, x) in path {
            let want = exact.advance(zeta, x).unwrap();
            let limit = exact.normal_force();
            for (law, tolerance) in laws.iter_mut().zip(tolerances) {
                let got = law.advance(zeta, x).unwrap();
                let off = (got[0] - want[0]).hypot(got[1] - want[1]) / limit;
                assert!(off < 1e-4, "{seed}, {:e}: {off:e}", tolerance.get());
            }
        }
    }
}

/// The error of the force over its limit by the rounding of the shift is none where the approach is small
/// beside it.
#[test]
fn the_force_is_within_its_limit_to_its_own_round_off() {
    let mut random = Splitmix(11);
    for tolerance in [1e-2, 1e-3, 1e-5] {
        for _ in 0..300 {
            let mut law = CoulombMemory::<[f64; 2]>::new(Tolerance::new(tolerance).unwrap());
            for _ in 0..20 {
                let zeta = 10_f64.powf(random.between(-6.0, 0.0));
                let x = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
                let [f_x, f_y] = law.advance(zeta, x).unwrap();
                let limit = law.normal_force();
                assert!(f_x.hypot(f_y) <= limit * (1.0 + 4e-15), "{zeta:e} {x:?}");
            }
        }
    }
}

#[test]
fn estimate_is_zero_but_for_round_off_where_the_law_is_exact() {
    for kind in [Kind::Adhesion, Kind::Collinear] {
        for seed in 0..20 {
            let mut law = CoulombMemory::<[f64; 2]>::new(Tolerance::PARTICLES);
            assert_eq!(law.error_estimate(), 0.0);
            for (zeta, x) in kind.path(&mut Splitmix(seed)) {
                law.advance(zeta, x).unwrap();
                if kind == Kind::Collinear {
                    assert!(law.error_estimate() < 1e-11, "{:e}", law.error_estimate());
                }
            }
        }
    }
}

/// The mean of the estimate over the mean of the error, on paths as they come.
fn ratio(kind: Kind, tolerance: f64, parts: usize) -> f64 {
    let (mut estimates, mut errors) = (0.0, 0.0);
    for seed in 0..6 {
        let path = divided(&kind.path(&mut Splitmix(seed)), parts);
        let mut law = CoulombMemory::<[f64; 2]>::new(Tolerance::new(tolerance).unwrap());
        let mut oracle = common::rings::Rings::new(2000, 1.3);
        for (i, &(zeta, x)) in path.iter().enumerate() {
            let force = law.advance(zeta, x).unwrap();
            if i % parts > 0 {
                continue;
            }
            let want = oracle.advance(zeta, x);
            if zeta < 0.2 {
                continue; // the rings are too few there
            }
            let limit = law.normal_force();
            errors += (force[0] - want[0]).hypot(force[1] - want[1]) / limit;
            estimates += law.error_estimate();
        }
    }
    estimates / errors
}

#[test]
fn estimate_is_of_use_on_ordinary_paths() {
    let kinds = [Kind::Turning, Kind::TurningVarying, Kind::Corners, Kind::Collision, Kind::Noise];
    for kind in kinds {
        let [whole, parted] = [1, 16].map(|parts| ratio(kind, 1e-2, parts));
        println!("{kind:?}: estimate over error {whole:.0}, each step in 16 parts {parted:.0}");
        assert!(whole < 1000.0 && parted < 1000.0);
    }
}

fn path() -> impl Strategy<Value = Vec<Point>> {
    let point = (0.02..1.5_f64, -1.5..1.5_f64, -1.5..1.5_f64, -3.0..0.0_f64);
    proptest::collection::vec(point, 2..14).prop_map(|points| {
        let mut at = (1.0, [0.0; 2]);
        let to = |(zeta, x, y, size): (f64, f64, f64, f64)| {
            // A part of the way, of all sizes.
            let part = 10_f64.powf(size);
            let mix = |from: f64, to: f64| from + part * (to - from);
            at = (mix(at.0, zeta), [mix(at.1[0], x), mix(at.1[1], y)]);
            at
        };
        points.into_iter().map(to).collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn estimate_covers_the_error_and_the_force_is_within_its_limit(path in path(), scale in -5.0..-2.0_f64) {
        let tolerance = 10_f64.powf(scale);
        for [error, estimate] in errors(&path, tolerance, 1500) {
            prop_assert!(error <= estimate + of_rings(1500), "{error:e} beyond {estimate:e}");
        }
        let mut law = CoulombMemory::<[f64; 2], FixedCurve<[f64; 2], 8>>::new(Tolerance::PARTICLES);
        for &(zeta, x) in &path {
            let [f_x, f_y] = law.advance(zeta, x).unwrap();
            prop_assert!(f_x.hypot(f_y) <= law.normal_force() * (1.0 + 4e-15));
        }
    }
}

/// The tolerance is a part of the estimate wherever slip turns, however little of it there is.
#[test]
fn an_estimate_is_at_least_the_tolerance_where_slip_turns() {
    for part in [0.1, 0.01, 1e-3, 1e-4] {
        let path = [(1.0, [0.0; 2]), (1.0, [part, 0.0]), (1.0, [part, part])];
        let [_, estimate] = error::<Growing<[f64; 2]>>(&path, 1e-3, [0.0; 2]);
        assert!(estimate >= 1e-3, "{part}: {estimate:e}");
    }
}
