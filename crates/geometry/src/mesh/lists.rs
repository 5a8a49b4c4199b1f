//! Lists of items, one for each of many owners, in one piece of memory.

#[derive(Debug, Clone)]
pub(super) struct Lists<T> {
    /// Begin and end of each list among the items.
    ranges: Vec<[u32; 2]>,
    items: Vec<T>,
}

impl<T: Copy + Default> Lists<T> {
    /// From pairs of owner and item; each list has the order of the pairs.
    pub(super) fn new(owners: usize, pairs: &[(u32, T)]) -> Self {
        let mut ranges = vec![[0, 0]; owners];
        for (owner, _) in pairs {
            ranges[*owner as usize][1] += 1;
        }
        let mut sum = 0;
        for range in &mut ranges {
            let count = std::mem::replace(range, [sum, sum])[1];
            sum += count;
        }
        let mut items = vec![T::default(); pairs.len()];
        for (owner, item) in pairs {
            let end = &mut ranges[*owner as usize][1];
            items[*end as usize] = *item;
            *end += 1;
        }
        Self { ranges, items }
    }

    /// The list of each member of a group becomes that of all.
    pub(super) fn share(&mut self, groups: &[Vec<u32>]) {
        for group in groups {
            let start = self.items.len() as u32;
            for member in group {
                let [from, to] = self.ranges[*member as usize];
                self.items.extend_from_within(from as usize..to as usize);
            }
            for member in group {
                self.ranges[*member as usize] = [start, self.items.len() as u32];
            }
        }
    }

    pub(super) fn of(&self, owner: u32) -> &[T] {
        self.run(owner as usize, owner as usize)
    }

    /// The lists of neighbouring owners, none of which is shared.
    pub(super) fn run(&self, first: usize, last: usize) -> &[T] {
        &self.items[self.ranges[first][0] as usize..self.ranges[last][1] as usize]
    }
}
