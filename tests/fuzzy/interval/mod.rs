mod elliptic;
mod network;
mod uncertain_gaussian;
