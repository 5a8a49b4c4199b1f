! A contact with memory from Fortran, by iso_c_binding: pressed, shifted to and fro.
!
!     gfortran contact.f90 $(pkg-config --libs carom) -o contact
module carom
  use, intrinsic :: iso_c_binding
  implicit none

  integer(c_int32_t), parameter :: carom_status_ok = 0, carom_status_out_of_range = 3
  integer(c_int32_t), parameter :: carom_law_coulomb = 0, carom_law_fixed_direction = 1

  type, bind(c) :: carom_material
    real(c_double) :: young_modulus, poisson, yield_stress = 0
  end type

  type, bind(c) :: carom_pair
    real(c_double) :: c_x, c_y, c_z, friction, tolerance, a_squared, b_squared, gamma, coupling_bound
    integer(c_int32_t) :: law, version
  end type

  type, bind(c) :: carom_contact
    integer(c_int64_t) :: words(145) = 0
  end type

  type, bind(c) :: carom_shift
    real(c_double) :: zeta = 0, xi = 0, eta = 0
  end type

  type, bind(c) :: carom_load
    real(c_double) :: f_x, f_y, f_z
  end type

  type, bind(c) :: carom_error
    integer(c_int64_t) :: index
    real(c_double) :: value
    character(kind=c_char) :: field(40), text(200)
  end type

  interface
    integer(c_int32_t) function carom_pair_of_spheres(material_1, material_2, radius_1, radius_2, &
        friction, law, tolerance, pair, error) bind(c)
      import
      type(carom_material), intent(in) :: material_1, material_2
      real(c_double), value :: radius_1, radius_2, friction, tolerance
      integer(c_int32_t), value :: law
      type(carom_pair), intent(out) :: pair
      type(carom_error), intent(inout) :: error
    end function

    integer(c_int32_t) function carom_contact_advance(pair, contact, shift, load, error) bind(c)
      import
      type(carom_pair), intent(in) :: pair
      type(carom_contact), intent(inout) :: contact
      type(carom_shift), value :: shift
      type(carom_load), intent(out) :: load
      type(carom_error), intent(inout) :: error
    end function

    integer(c_int32_t) function carom_contact_energy(pair, contact, energy, error) bind(c)
      import
      type(carom_pair), intent(in) :: pair
      type(carom_contact), intent(in) :: contact
      real(c_double), intent(out) :: energy
      type(carom_error), intent(inout) :: error
    end function
  end interface
end module

program contact
  use carom
  implicit none
  type(carom_material) :: rubber = carom_material(5.0e6_c_double, 0.5_c_double, 0.0_c_double)
  type(carom_pair) :: pair
  type(carom_contact) :: memory
  type(carom_shift) :: shift
  type(carom_load) :: load
  type(carom_error) :: error
  real(c_double) :: energy, there, back, limit
  integer :: i

  call check(carom_pair_of_spheres(rubber, rubber, 0.02_c_double, 0.03_c_double, 0.8_c_double, &
    carom_law_fixed_direction, 0.0_c_double, pair, error))

  ! Press, shift, and reverse the shift completely: the loop is symmetric.
  shift%zeta = 1.0e-3_c_double
  call check(carom_contact_advance(pair, memory, shift, load, error))
  shift%xi = 4.0e-4_c_double
  call check(carom_contact_advance(pair, memory, shift, load, error))
  there = load%f_x
  do i = 1, 100
    shift%xi = 4.0e-4_c_double*(1 - 0.02_c_double*i)
    call check(carom_contact_advance(pair, memory, shift, load, error))
  end do
  back = load%f_x
  call check(carom_contact_energy(pair, memory, energy, error))
  print '(a, es14.6, a, es14.6, a, es14.6)', 'F_x = ', there, ' N, back ', back, ' N; energy ', energy

  if (abs(there + back) > 1.0e-12_c_double*abs(there)) error stop 'the loop is not symmetric'
  ! Cattaneo and Mindlin: F_x = f F_z (1 - (1 - c_x xi/(f c_z zeta))^1.5).
  limit = 0.8_c_double*load%f_z
  if (abs(there - limit*(1 - (1 - pair%c_x*4.0e-4_c_double/(0.8_c_double*pair%c_z*shift%zeta))**1.5d0)) &
      > 1.0e-12_c_double*limit) error stop 'not the force of Cattaneo and Mindlin'

  shift%zeta = ieee_nan()
  if (carom_contact_advance(pair, memory, shift, load, error) /= carom_status_out_of_range) &
    error stop 'a shift that is no number was taken'
  if (error%field(1) /= 'z') error stop 'the field is not named'
  print '(a)', 'all is well'

contains

  real(c_double) function ieee_nan()
    use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
    ieee_nan = ieee_value(0.0_c_double, ieee_quiet_nan)
  end function

  subroutine check(status)
    integer(c_int32_t), intent(in) :: status
    integer :: end
    if (status == carom_status_ok) return
    end = 1
    do while (end < 200 .and. error%text(end) /= c_null_char)
      end = end + 1
    end do
    print *, error%text(:end - 1)
    error stop 1
  end subroutine
end program
