//! Rooted trees up to order six, and the differential equations whose solutions they are.

use brunovsky::integrators::Linearization;
use nalgebra::{SMatrix, SVector};

/// 1 + 1 + 2 + 4 + 9 + 20 trees with up to six nodes.
pub const TREES: usize = 37;

/// A tree, by the trees that hang on its root.
#[derive(Clone)]
pub struct Tree {
    pub children: Vec<usize>,
    /// ρ: the number of nodes.
    pub order: i32,
    /// γ: the product of the orders of all subtrees.
    pub density: f64,
}

/// All of them, smaller ones first: the leaf, and every multiset of smaller trees on a root.
pub fn trees() -> Vec<Tree> {
    let mut trees = vec![Tree { children: vec![], order: 1, density: 1.0 }];
    for order in 2..=6 {
        let mut found = Vec::new();
        multisets(&trees, order - 1, 0, &mut vec![], &mut found);
        let new = found.into_iter().map(|children| {
            let product: f64 = children.iter().map(|&child: &usize| trees[child].density).product();
            Tree { children, order, density: f64::from(order) * product }
        });
        let new: Vec<_> = new.collect();
        trees.extend(new);
    }
    assert_eq!(trees.len(), TREES);
    trees
}

/// The multisets of trees, from number `first` on, with `nodes` nodes together.
fn multisets(
    trees: &[Tree],
    nodes: i32,
    first: usize,
    chosen: &mut Vec<usize>,
    found: &mut Vec<Vec<usize>>,
) {
    if nodes == 0 {
        found.push(chosen.clone());
    }
    for (i, tree) in trees.iter().enumerate().skip(first) {
        if tree.order <= nodes {
            chosen.push(i);
            multisets(trees, nodes - tree.order, i, chosen, found);
            chosen.pop();
        }
    }
}

/// ẋ_τ = Π x_child: from 0, component τ of the solution is t^ρ(τ)/γ(τ), and that of one step of length 1 is the elementary weight of τ.
pub fn rate(trees: &[Tree], x: &SVector<f64, TREES>) -> SVector<f64, TREES> {
    SVector::from_fn(|i, _| trees[i].children.iter().map(|&child| x[child]).product())
}

/// Its derivative by the product rule.
pub fn linearization(trees: &[Tree], x: &SVector<f64, TREES>) -> Linearization<f64, TREES> {
    let mut jacobian = SMatrix::zeros();
    for (i, tree) in trees.iter().enumerate() {
        for (k, &child) in tree.children.iter().enumerate() {
            let others = tree.children.iter().enumerate().filter(|(other, _)| *other != k);
            jacobian[(i, child)] += others.map(|(_, &other)| x[other]).product::<f64>();
        }
    }
    Linearization { x: jacobian, t: SVector::zeros() }
}
