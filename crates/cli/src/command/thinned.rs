//! Records for a line plot, thinned while they arrive. Few records are all kept. Of many, the
//! first, last, smallest and largest of each group of neighbours are kept, for every drawn
//! quantity.

use super::plot::Value;

/// Largest number of records of a picture.
pub(super) const MOST_DRAWN: usize = 20_000;

/// A bounded number of records in order. A line through them passes through the extrema of every
/// quantity within groups of neighbours that are narrower than a fraction of a pixel.
#[derive(Debug, Clone)]
pub(super) struct Thinned<T> {
    quantities: Vec<Value<T>>,
    kept: Vec<T>,
    /// Number of records in a group of which some are kept; 1 while all are kept.
    share: usize,
    waiting: Vec<T>,
}

impl<T: Clone> Thinned<T> {
    /// No records yet; `quantities` are the drawn ones.
    pub(super) fn new(quantities: impl Into<Vec<Value<T>>>) -> Self {
        Self { quantities: quantities.into(), kept: Vec::new(), share: 1, waiting: Vec::new() }
    }

    /// Adds a record at the end.
    pub(super) fn push(&mut self, record: T) {
        self.waiting.push(record);
        if self.waiting.len() < self.share {
            return;
        }
        let waiting = std::mem::take(&mut self.waiting);
        self.keep(&waiting);
        if self.kept.len() > MOST_DRAWN {
            let all = std::mem::take(&mut self.kept);
            let share = 2 * self.most_kept();
            all.chunks(share).for_each(|records| self.keep(records));
            self.share = (2 * self.share).max(share);
        }
    }

    /// Largest number kept of a group: its ends, and the extrema of each quantity.
    fn most_kept(&self) -> usize {
        2 + 2 * self.quantities.len()
    }

    fn keep(&mut self, records: &[T]) {
        if records.len() <= self.most_kept() {
            self.kept.extend_from_slice(records);
            return;
        }
        let mut places = vec![0, records.len() - 1];
        for quantity in &self.quantities {
            let values = || records.iter().map(quantity).enumerate();
            let least = values().min_by(|one, other| one.1.total_cmp(&other.1));
            let greatest = values().max_by(|one, other| one.1.total_cmp(&other.1));
            places.extend(least.into_iter().chain(greatest).map(|(place, _)| place));
        }
        places.sort_unstable();
        places.dedup();
        self.kept.extend(places.into_iter().map(|place| records[place].clone()));
    }

    /// The records to draw.
    pub(super) fn records(mut self) -> Vec<T> {
        let waiting = std::mem::take(&mut self.waiting);
        self.keep(&waiting);
        self.kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn thinned(count: usize, value: impl Fn(usize) -> f64) -> Vec<[f64; 2]> {
        let quantities: [Value<[f64; 2]>; 1] = [|point| point[1]];
        let mut thinned = Thinned::new(quantities);
        (0..count).for_each(|i| thinned.push([i as f64, value(i)]));
        thinned.records()
    }

    #[test]
    fn few_records_are_all_kept() {
        let kept = thinned(MOST_DRAWN, |i| i as f64);
        assert!(kept.iter().enumerate().all(|(i, point)| point[0] == i as f64));
        assert_eq!(kept.len(), MOST_DRAWN);
    }

    #[test]
    fn of_many_records_the_ends_and_every_spike_are_kept_in_order() {
        let spikes = [7, 123_456, 500_001, 999_998];
        let value = |i: usize| match spikes.iter().position(|spike| *spike == i) {
            Some(spike) => {
                if spike % 2 == 0 {
                    10.0 + spike as f64
                } else {
                    -10.0 - spike as f64
                }
            }
            None => (i as f64 * 0.37).sin(),
        };
        let kept = thinned(1_000_000, value);
        assert!((MOST_DRAWN / 4..=MOST_DRAWN).contains(&kept.len()), "{}", kept.len());
        assert!(kept.windows(2).all(|two| two[0][0] < two[1][0]));
        assert_eq!((kept[0][0], kept[kept.len() - 1][0]), (0.0, 999_999.0));
        for spike in spikes {
            assert!(kept.contains(&[spike as f64, value(spike)]), "{spike}");
        }
        // Every part of the line has points.
        let widest = kept.windows(2).map(|two| two[1][0] - two[0][0]).fold(0.0, f64::max);
        assert!(widest < 2000.0, "{widest}");
    }
}
