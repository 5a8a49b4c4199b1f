//! Reads the cases of an input of CONTACT in the order of the file.

mod friction;
mod motion;
mod sequence;
mod springs;

use super::block::Block;
use super::case::{Asked, ContactCase, ContactDrive, Rolling};
use super::digits::Digits;
use super::falling::Falling;
use super::fault::Fault;
use super::lines::{Given, Lines};
use super::potential::{Area, Potential};
use super::springs::Fastsim;
use super::surface::Surface;
use carom_halfspace::{Material, MaterialPair};
use carom_solver::Driven;
use carom_special::Readable;
use std::sync::Arc;

/// The most cases of a file.
const MOST_CASES: usize = 10_000;
/// CONTACT's least moduli and its largest.
const MODULI: [f64; 2] = [1e-5, 1e20];
/// CONTACT's default of FACPHI.
const FACPHI: f64 = 1.0 / 6.0;

/// Reads all cases of a file.
///
/// # Errors
/// [`Fault`] that names the line, the number and what is allowed.
pub fn cases(text: &str) -> Result<Vec<ContactCase>, Fault> {
    let (mut reader, mut cases) = (Reader::new(text), Vec::new());
    let mut has_module = true;
    loop {
        if has_module && !reader.module()? {
            return Ok(cases);
        }
        if reader.number == MOST_CASES {
            let line = reader.lines.last();
            return Err(Fault::new(line, "MODULE", 3, format!("0 after {MOST_CASES} cases")));
        }
        let (case, return_digit) = reader.case()?;
        if return_digit < 2 {
            cases.push(case);
        }
        has_module = return_digit % 2 == 1;
    }
}

/// What a file has said so far.
struct Reader<'a> {
    lines: Lines<'a>,
    number: usize,
    /// The digits of the three lines of the present case.
    digits: [Digits; 3],
    line: usize,
    solver: u8,
    eps: f64,
    was_rolling: bool,
    friction: Option<(Arc<[f64]>, bool)>,
    falling: Option<Falling>,
    rolling: Option<Rolling>,
    materials: Option<MaterialPair>,
    fastsim: Option<Fastsim>,
    influence: Option<String>,
    /// The area as it is given, as it lies, and the surface that it gives.
    area: Option<Area>,
    placed: Option<Potential>,
    surface: Option<Arc<Surface>>,
    extra: Option<Arc<[[f64; 2]]>>,
    blocks: Arc<[Block]>,
    /// The cells of the last case that was solved.
    solved: Option<Potential>,
}

/// Names of the digits by line and place.
macro_rules! digits {
    ($($name:ident: $line:literal, $place:literal;)*) => {
        impl Reader<'_> {
            $(const fn $name(&self) -> u8 {
                self.digits[$line].at($place)
            })*
        }
    };
}

digits! {
    pvtime: 0, 1; bound: 0, 2; tang: 0, 3; norm: 0, 4; force: 0, 5; stress: 0, 6;
    varfrc: 1, 0; frclaw: 1, 1; discns: 1, 2; inflcf: 1, 3; mater: 1, 4; rznorm: 1, 5; exrhs: 1, 6;
    xflow: 2, 0; gausei: 2, 2; ret: 2, 7;
}

impl<'a> Reader<'a> {
    fn new(text: &'a str) -> Self {
        Self {
            lines: Lines::new(text),
            number: 0,
            digits: [Digits::default(); 3],
            line: 0,
            solver: 0,
            eps: 1e-5,
            was_rolling: false,
            friction: None,
            falling: None,
            rolling: None,
            materials: None,
            fastsim: None,
            influence: None,
            area: None,
            placed: None,
            surface: None,
            extra: None,
            blocks: Arc::new([]),
            solved: None,
        }
    }

    /// Whether another case follows.
    fn module(&mut self) -> Result<bool, Fault> {
        let [module] = self.lines.numbers(["MODULE"])?;
        match module.value {
            0.0 => Ok(false),
            3.0 => Ok(true),
            1.0 => {
                let value = "1 (wheel on rail), which carom does not do,";
                Err(Fault::new(module.line, "MODULE", value, "3, or 0 at the end"))
            }
            _ => Err(module.must("3, or 0 at the end")),
        }
    }

    /// A digit that is out of place in this case.
    fn digit(&self, name: &str, value: u8, allowed: &str) -> Fault {
        Fault::new(self.line, format!("control digit {name}"), value, allowed)
    }

    const fn is_rolling(&self) -> bool {
        matches!(self.tang(), 2 | 3)
    }

    fn case(&mut self) -> Result<(ContactCase, u8), Fault> {
        self.number += 1;
        for line in 0..3 {
            let words = self.lines.expect("the line of control digits")?;
            if line == 0 {
                self.line = self.lines.last();
            }
            let word = words.first().copied().unwrap_or_default();
            self.digits[line] = Digits::read(line, self.lines.last(), word)?;
            if let (1, Some("1" | "2")) = (line, words.get(1).copied()) {
                let value = format!("{}, which carom does not do,", words[1]);
                return Err(Fault::new(self.lines.last(), "weighting of the gap", value, "0"));
            }
        }
        self.check_sequence()?;
        if self.xflow() == 1 {
            self.lines.expect("debug output")?;
        }
        self.solver_numbers()?;
        let drive = self.drive()?;
        self.check_springs()?;
        self.uniform_friction()?;
        if self.inflcf() >= 2 {
            self.bodies()?;
        }
        self.place(drive.normal)?;
        self.per_cell()?;
        Ok((self.complete(drive)?, self.ret()))
    }

    /// The numbers of CONTACT's solvers, of which carom takes none but EPS.
    fn solver_numbers(&mut self) -> Result<(), Fault> {
        let digit = self.gausei();
        if digit == 1 {
            return Ok(());
        }
        self.solver = digit;
        let lines = &mut self.lines;
        let [maxgs, maxin, maxnr, maxout, eps] =
            lines.numbers(["MAXGS", "MAXIN", "MAXNR", "MAXOUT", "EPS"])?;
        maxin.whole([1, 999_999])?;
        for count in [maxgs, maxnr, maxout] {
            count.whole([1, 9999])?;
        }
        self.eps = eps.checked(|eps| eps > 0.0 && eps < 1.0, "> 0 and < 1")?;
        match digit {
            2 | 3 => lines.numbers(["OMEGAH", "OMEGAS", "INISLP", "OMGSLP"]).map(drop),
            4 => lines.numbers(["INISLP", "OMGSLP"]).map(drop),
            5 => lines
                .numbers([
                    "FDECAY", "BETATH", "KDOWFB", "D_IFC", "D_LIN", "D_CNS", "D_SLP", "POW_S",
                ])
                .map(drop),
            _ => Ok(()),
        }
    }

    /// Approach or force, creepages or forces, and spin.
    fn drive(&mut self) -> Result<ContactDrive, Fault> {
        let (norm, force) = (self.norm(), self.force());
        let names = [
            if norm == 0 { "PEN" } else { "FN" },
            if force == 0 { "CKSI" } else { "FX" },
            if force < 2 { "CETA" } else { "FY" },
            "CPHI",
        ];
        let ([first, x, y, spin], more) = self.lines.with_more(names, &["SPINXO", "SPINYO"])?;
        let normal = match norm {
            0 => Driven::Shift(first.value),
            _ => Driven::Load(first.positive()?),
        };
        let along = [relative(&x, force > 0)?, relative(&y, force > 1)?];
        if force > 1 && x.value.hypot(y.value) > 1.0 {
            return Err(y.must("such that FX and FY together are at most 1"));
        }
        let spin_centre = match more.as_slice() {
            [] => [0.0; 2],
            [only] => return Err(only.must("followed by SPINYO")),
            [x, y, ..] => [x.value, y.value],
        };
        Ok(ContactDrive { normal, along, spin: spin.value, spin_centre })
    }

    /// How it rolls, influence numbers and materials.
    fn bodies(&mut self) -> Result<(), Fault> {
        if self.is_rolling() {
            let all = self.lines.angle_first(["CHI", "DQ", "VELOC"], &["FACPHI"])?;
            let facphi = match all.get(3) {
                Some(given) => given.checked(|part| part.abs() <= 1.0, "from -1 to 1")?,
                None => FACPHI,
            };
            let (dq, veloc) = (all[1].positive()?, all[2].positive()?);
            self.rolling = Some(Rolling { chi: all[0].value, dq, veloc, facphi });
        }
        self.influence = None;
        if self.inflcf() == 9 {
            let words = self.lines.expect("CFNAME")?;
            let name = words.first().copied().unwrap_or_default();
            let inner = name.strip_prefix('\'').and_then(|name| name.strip_suffix('\''));
            let inner = inner.filter(|name| !name.is_empty()).ok_or_else(|| {
                Fault::new(
                    self.lines.last(),
                    "CFNAME",
                    name,
                    "the name of a file in quotes: 'name'",
                )
            })?;
            self.influence = Some(inner.to_owned());
        }
        let [nu_1, nu_2, g_1, g_2] = self.lines.numbers(["POISS1", "POISS2", "GG1", "GG2"])?;
        let body = |nu: &Given, g: &Given| {
            nu.checked(|nu| (0.0..=0.5).contains(&nu), "from 0 to 0.5")?;
            g.checked(|g| (MODULI[0]..=MODULI[1]).contains(&g), "from 1e-5 to 1e20")?;
            Material::from_shear(g.value, nu.value).map_err(|error| g.must(error.allowed))
        };
        let pair = MaterialPair::new(body(&nu_1, &g_1)?, body(&nu_2, &g_2)?);
        self.materials = Some(pair.map_err(|error| g_2.must(error.allowed))?);
        self.fastsim = match self.mater() {
            mater @ (2 | 3) => Some(Fastsim::read(&mut self.lines, mater)?),
            _ => None,
        };
        Ok(())
    }

    /// Cells and undeformed distance.
    fn place(&mut self, normal: Driven) -> Result<(), Fault> {
        if self.discns() == 2 {
            self.area = Some(Area::read(&mut self.lines)?);
        }
        let (Some(area), Some(materials)) = (self.area, self.materials) else {
            return Err(self.digit("D (DISCNS)", self.discns(), "2 in the first case"));
        };
        let mut surface = None;
        if self.discns() > 0 || (area.is_hertzian() && self.rznorm() > 0) {
            let placed = area.placed(materials, normal)?;
            surface = placed.surface;
            if self.discns() > 0 {
                self.placed = Some(placed.area);
            }
        }
        if self.rznorm() == 2 && !area.is_hertzian() {
            let cells = self.placed.map_or(0, |placed| placed.count());
            surface = Some(Surface::read(&mut self.lines, cells)?);
        }
        if let Some(surface) = surface {
            self.surface = Some(Arc::new(surface));
        }
        Ok(())
    }

    /// Friction of rows, extra slip of cells, and points below the surface.
    fn per_cell(&mut self) -> Result<(), Fault> {
        let [columns, rows] = self.placed.map_or([0, 0], |placed| placed.cells);
        self.friction_of_rows(rows)?;
        match self.exrhs() {
            0 => self.extra = None,
            9 => {
                let all = self.lines.list("extra rigid slip", 2 * columns * rows)?;
                let pairs = all.chunks_exact(2).map(|pair| [pair[0], pair[1]]);
                self.extra = Some(pairs.collect());
            }
            _ => {}
        }
        if self.stress() >= 2 {
            let [matfil, output] = self.lines.numbers(["MATFIL", "OUTPUT"])?;
            matfil.whole([0, 2])?;
            output.whole([0, 4])?;
        }
        if self.stress() == 3 {
            self.blocks = Block::read_all(&mut self.lines)?.into();
        }
        Ok(())
    }

    /// The case, with what the file has said before.
    fn complete(&mut self, drive: ContactDrive) -> Result<ContactCase, Fault> {
        let missing = |name| self.digit(name, 0, "2 in the first case");
        let (friction, by_friction) = self.friction.clone().ok_or_else(|| missing("L (FRCLAW)"))?;
        let area = self.placed.ok_or_else(|| missing("D (DISCNS)"))?;
        let surface = self.surface.clone().ok_or_else(|| missing("Z (RZNORM)"))?;
        let materials = self.materials.ok_or_else(|| missing("C (INFLCF)"))?;
        if friction.len() > 1 && friction.len() != area.cells[1] {
            let allowed = "0, or 2 with as many rows of friction as of cells";
            return Err(self.digit("V (VARFRC)", self.varfrc(), allowed));
        }
        if self.extra.as_ref().is_some_and(|extra| extra.len() != area.count()) {
            return Err(self.digit("E (EXRHS)", self.exrhs(), "0 or 9 with other cells"));
        }
        let mut notes = in_pascal(&materials);
        let falling = self.falling_friction(&mut notes)?;
        let motion = self.motion(area, &mut notes)?;
        let begin = self.begin(area, motion, &mut notes)?;
        self.was_rolling = self.is_rolling();
        if self.ret() < 2 {
            self.solved = Some(area);
        }
        let (bound, ellipse) = self.pressures(materials, drive.normal)?;
        let wanted = self.stress() > 0;
        Ok(ContactCase {
            number: self.number,
            line: self.line,
            begin,
            motion,
            drive,
            friction,
            falling,
            by_friction,
            bound,
            ellipse,
            fastsim: self.fastsim,
            materials,
            influence: self.influence.clone(),
            area,
            surface,
            extra: self.extra.clone(),
            blocks: if wanted { Arc::clone(&self.blocks) } else { Arc::new([]) },
            eps: self.eps,
            notes,
        })
    }
}

/// A creepage, or a relative force.
fn relative(given: &Given, is_force: bool) -> Result<Asked, Fault> {
    if !is_force {
        return Ok(Asked::Creepage(given.value));
    }
    given
        .checked(|force| force.abs() <= 1.0, "from -1 to 1: a force over FSTAT FN")
        .map(Asked::Force)
}

/// Shear moduli in N/mm2 that are probably in Pa; still greater ones stand for rigid bodies.
const PROBABLY_PASCAL: [f64; 2] = [1e8, 1e13];

/// Notes on moduli that are probably in Pa.
fn in_pascal(materials: &MaterialPair) -> Vec<String> {
    let both = [("GG1", materials.body_1()), ("GG2", materials.body_2())];
    let moduli = both.map(|(name, body)| (name, body.shear_modulus()));
    let unusual = moduli
        .into_iter()
        .filter(|(_, modulus)| (PROBABLY_PASCAL[0]..PROBABLY_PASCAL[1]).contains(modulus));
    unusual
        .map(|(name, modulus)| {
            format!(
                "{name} = {} is unusual: it is in N/mm2, and steel has 82000",
                Readable(modulus)
            )
        })
        .collect()
}
