//! The chart of the program: its modules and questions.

use std::fmt;

use crate::chart::Block;

/// The modules and questions of [`PROGRAM`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProgramStep {
    /// One sweep of (12.17).
    Sweep,
    /// Whether the stresses have converged.
    StressesStand,
    /// The displacements (12.10).
    Displacements,
    /// Tests (12.3) and (12.6) and corrects the contact area.
    TestContact,
    /// Whether the contact area has converged.
    ContactStands,
    /// Corrects the directions of slip, (12.21).
    SlipAlgorithm,
    /// Whether the directions of slip have converged.
    DirectionsStand,
    /// Adds elements that slip in the direction of their stress to the stick area.
    TestSign,
    /// Removes elements with too large a stress from the stick area.
    DefineStickArea,
    /// Coulomb's stress in the slip area.
    DefineSlipStress,
    /// Whether the stick area has converged.
    StickAreaStands,
    /// Tests all conditions.
    TestAll,
    /// Whether all conditions are satisfied.
    AllHold,
}

impl fmt::Display for ProgramStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sweep => "SeidTang: one sweep of (12.17)",
            Self::StressesStand => "stresses stand, or MaxSeidel",
            Self::Displacements => "Displacements (12.10)",
            Self::TestContact => "TestContact (12.3), (12.6)",
            Self::ContactStands => "contact area stands, or MaxContact",
            Self::SlipAlgorithm => "SlipAlgorithm (12.21): blocks of rows",
            Self::DirectionsStand => "slip directions stand, or MaxSlip",
            Self::TestSign => "Testsign: slip along the stress sticks",
            Self::DefineStickArea => "DefineStickArea: too large a stress slips",
            Self::DefineSlipStress => "DefineSlipStress",
            Self::StickAreaStands => "stick area stands, or MaxStick",
            Self::TestAll => "test all conditions",
            Self::AllHold => "all hold, or MaxProgram",
        })
    }
}

/// The chart of the program. In the thesis a module of its own at the end of the loops defines the
/// constants of the stick area; here they are those of the step and need no correction. `TestSign`
/// comes before `DefineStickArea`, so that it tests elements that have slipped.
pub const PROGRAM: &[Block<ProgramStep>] = &[Block::Until {
    body: &[
        Block::Until {
            body: &[
                Block::Until {
                    body: &[
                        Block::Until {
                            body: &[
                                Block::Until {
                                    body: &[Block::Do(ProgramStep::Sweep)],
                                    done: ProgramStep::StressesStand,
                                },
                                Block::Do(ProgramStep::Displacements),
                                Block::Do(ProgramStep::TestContact),
                            ],
                            done: ProgramStep::ContactStands,
                        },
                        Block::Do(ProgramStep::SlipAlgorithm),
                    ],
                    done: ProgramStep::DirectionsStand,
                },
                Block::Do(ProgramStep::TestSign),
                Block::Do(ProgramStep::DefineStickArea),
                Block::Do(ProgramStep::DefineSlipStress),
            ],
            done: ProgramStep::StickAreaStands,
        },
        Block::Do(ProgramStep::TestAll),
    ],
    done: ProgramStep::AllHold,
}];
