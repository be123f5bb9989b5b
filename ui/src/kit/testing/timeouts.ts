/**
 * Waiting for an element may take as long as the test: the library's limit of 1 s is short on a
 * busy PC.
 */

import { configure } from "@testing-library/preact";

configure({ asyncUtilTimeout: 20_000 });
