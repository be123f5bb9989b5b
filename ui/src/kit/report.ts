type Reporter = (error: unknown) => void;

let reporter: Reporter = (error) => {
  throw error;
};

/** The shell says at the start where failures are shown; without it they are errors of the page. */
export function reportTo(shown: Reporter): void {
  reporter = shown;
}

/** Shows a failure in the one error line under the header. */
export function report(error: unknown): void {
  reporter(error);
}

/** Resolves when what a handler began has ended, and reports its failure. */
export async function settled(result: unknown): Promise<void> {
  try {
    await result;
  } catch (error) {
    report(error);
  }
}
