__kernel void nothing() {}
