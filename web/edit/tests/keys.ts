// Keys of tests.
export const kRunTestsKey = "f8";
export const kCycleBackKey = ",";
export const kCycleOnKey = ".";
