import { availableParallelism } from "node:os";
import { defineConfig } from "vitest/config";
import { BaseSequencer, type Reporter, type TestCase, type TestSpecification } from "vitest/node";

/** By far the longest, though its text is short. Begun late, it would run on alone while the other processors stand idle. */
const kLongest = "designer/corpus.test.ts";

/** Where nothing is known from a run before, the others follow by the length of their texts. */
class LongestFirst extends BaseSequencer {
  override async sort(files: TestSpecification[]): Promise<TestSpecification[]> {
    const sorted = await super.sort(files);
    const isLongest = (file: TestSpecification) => file.moduleId.endsWith(kLongest);
    return [...sorted.filter(isLongest), ...sorted.filter((file) => !isLongest(file))];
  }
}

/** Names tests that failed and passed when they were tried again, as `./mlab test` expects it, and what they failed with. */
class NamesUnsteady implements Reporter {
  onTestCaseResult(test: TestCase) {
    if (!test.diagnostic()?.flaky) return;
    console.log(`Unsteady: ${test.module.relativeModuleId} > ${test.fullName}`);
    for (const error of test.result().errors ?? []) console.log(error.stack ?? error.message);
  }
}

// Each test has an mlab and a page of its own. More than half of the time it waits for them, so that files of tests run side by
// side, more of them than there are processors.
export default defineConfig({
  root: import.meta.dirname,
  test: {
    environment: "node",
    globalSetup: "./one_browser.ts",
    include: ["**/*.test.ts"],
    sequence: { sequencer: LongestFirst },
    maxWorkers: Math.min(4, availableParallelism() + 1),
    testTimeout: 300_000,
    hookTimeout: 120_000,
    retry: 1,
    reporters: ["default", new NamesUnsteady()],
    expect: { poll: { timeout: 90_000 } },
  },
});
