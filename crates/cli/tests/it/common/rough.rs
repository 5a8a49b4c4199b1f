//! Cases on a grid with heights in a file.

/// A ball on a rough plane of 8 x 8 cells, its heights in `file`; two steps.
pub(crate) fn rough(file: &str) -> String {
    format!(
        "[body_1]\nmaterial = {{ shear_modulus = 1, poisson = 0.3 }}\n\
         [body_2]\nmaterial = {{ rigid = true }}\n\
         [gap]\nshape = \"heights\"\nfile = \"{file}\"\nradius = 10\nscale = 0.01\n\
         [grid]\ncells = [8, 8]\nsize = [8, 8]\n\
         [contact]\nfriction = 0.3\n\
         [[step]]\nF_z = 0.2\n[[step]]\nxi = 0.01\n"
    )
}

/// A table of 8 x 8 heights.
pub(crate) fn heights() -> String {
    let row = |i: usize| (0..8).map(|j| format!("{}", (i * j) % 5)).collect::<Vec<_>>();
    (0..8).map(|i| row(i).join(",") + "\n").collect()
}

/// The same as a picture in greys.
pub(crate) fn grey_heights() -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 8, 8);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Eight);
    let greys: Vec<u8> = (0..64).map(|i| (i / 8) * (i % 8) % 5).collect();
    encoder.write_header().unwrap().write_image_data(&greys).unwrap();
    bytes
}
