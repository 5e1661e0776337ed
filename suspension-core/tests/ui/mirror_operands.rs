suspension_core::linkage! {
    mod m {
        mirror: left -> right;
        mirror: front -> rear;
        fixed: a;
        free: left, right_hub;
        drive z: left.z;
    }
}

suspension_core::linkage! {
    mod nothing {
        mirror: near -> far;
        fixed: a;
        free: p;
        link rod: a -> p;
        drive z: p.z;
        drive y: p.y;
    }
}

suspension_core::linkage! {
    mod both {
        mirror: left -> right;
        fixed: a;
        free: left, right;
        link left_rod: a -> left;
        drive z_left: left.z;
        drive y_left: left.y;
    }
}

fn main() {}
