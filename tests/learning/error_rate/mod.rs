mod conditional;
mod differentiated;
mod measured;
mod model_aided;
mod of_state;
mod redundant;
