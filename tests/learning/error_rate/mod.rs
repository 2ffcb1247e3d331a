mod conditional;
mod differentiated;
mod feedback_error;
mod measured;
mod model_aided;
mod of_state;
mod redundant;
