type Reporter = (error: unknown) => void;

let reporter: Reporter = (error) => {
  throw error;
};

/**
 * Sets the function that shows failures; the shell calls it at the start. Before that, `report`
 * throws.
 */
export function reportTo(shown: Reporter): void {
  reporter = shown;
}

/** Shows a failure in the error line under the header. */
export function report(error: unknown): void {
  reporter(error);
}

/** Awaits the result of a handler and reports its failure. */
export async function settled(result: unknown): Promise<void> {
  try {
    await result;
  } catch (error) {
    report(error);
  }
}
