//! The picture of stresses in a plane: body 1 lies above the contact, body 2 below it.

use crate::common::{case, fresh, stdout};

/// A ball of 10 mm on a plane, pressed with 100 N: the greatest stress lies at .48 of the contact radius, 0.31 mm.
fn below(name: &str, inside: &str) -> String {
    let body = |name: &str, radii: &str| {
        format!(
            "[{name}]\nradii = {radii}\nmaterial = {{ young_modulus = 208e9, poisson = 0.3 }}\n"
        )
    };
    let rest = format!(
        "[contact]\nangle = 0\nfriction = 0.3\n[load]\nforce = 100\nforce_x = 0\nforce_y = 0\n[points]\ninside = \"{inside}\"\n\
         x = {{ start = -4e-4, stop = 4e-4, count = 41 }}\ny = 0\n\
         depth = {{ start = 0, stop = 6e-4, count = 61 }}\n"
    );
    case(name, &(body("body_1", "0.01") + &body("body_2", "inf") + &rest))
}

fn bytes(base64: &str) -> Vec<u8> {
    let digit = |letter: u8| match letter {
        b'A'..=b'Z' => letter - b'A',
        b'a'..=b'z' => letter - b'a' + 26,
        b'0'..=b'9' => letter - b'0' + 52,
        b'+' => 62,
        _ => 63,
    };
    let letters: Vec<u8> = base64.bytes().filter(|letter| *letter != b'=').collect();
    let four = |four: &[u8]| {
        let bits = four.iter().fold(0_u32, |bits, letter| (bits << 6) | u32::from(digit(*letter)));
        let bits = bits << (6 * (4 - four.len()));
        bits.to_be_bytes()[1..four.len()].to_vec()
    };
    letters.chunks(4).flat_map(four).collect()
}

fn between<'a>(text: &'a str, before: &str, after: &str) -> &'a str {
    let rest = text.split(before).nth(1).unwrap_or_else(|| panic!("no {before}"));
    rest.split(after).next().unwrap()
}

/// How far from the top of the field, from 0 to 1: the darkest pixel of its middle column, and the cross.
fn drawn(inside: &str) -> [f64; 2] {
    let file = fresh(&format!("stress_in_{}.svg", &inside[5..]));
    let text = below(&format!("stress_field_{}.toml", &inside[5..]), inside);
    stdout(&["stress", &text, "--plot", file.to_str().unwrap()]);
    let svg = std::fs::read_to_string(&file).unwrap();
    let image = between(&svg, "<image ", "/>");
    let number = |name: &str| between(image, &format!("{name}=\""), "\"").parse::<f64>().unwrap();
    let png = bytes(between(image, "base64,", "\""));
    let mut decoder = png::Decoder::new(std::io::Cursor::new(png));
    decoder.set_transformations(png::Transformations::IDENTITY);
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let (width, height) = (info.width as usize, info.height as usize);
    let column: Vec<u8> = (0..height).map(|row| pixels[row * width + width / 2]).collect();
    let most = *column.iter().max().unwrap();
    let darkest: Vec<usize> = (0..height).filter(|row| column[*row] == most).collect();
    let middle = darkest.iter().sum::<usize>() as f64 / darkest.len() as f64;
    // The two strokes of the cross have its middle.
    let is_cross =
        |line: &&str| line.starts_with("<line ") && line.contains("stroke-width=\"1.4\"");
    let cross = svg.lines().find(is_cross).unwrap();
    let end = |name: &str| between(cross, &format!("{name}=\""), "\"").parse::<f64>().unwrap();
    let y = 0.5 * (end("y1") + end("y2"));
    [(middle + 0.5) / height as f64, (y - number("y")) / number("height")]
}

#[test]
fn each_body_lies_on_its_side_of_the_contact() {
    // a^3 = 3 F R (1 - nu^2)/(2 E), the depth .48 a of 0.6 mm.
    let radius = (1.5_f64 * 100.0 * 0.01 * 0.91 / 208e9).cbrt();
    let part = 0.48 * radius / 6e-4;
    assert!(part < 0.4, "{part}");
    for (inside, expected) in [("body 1", 1.0 - part), ("body 2", part)] {
        for place in drawn(inside) {
            assert!((place - expected).abs() < 0.04, "{inside}: {place}, not {expected}");
        }
    }
}
