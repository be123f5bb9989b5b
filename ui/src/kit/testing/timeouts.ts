/** Waiting for what a component shows ends at the bound of the test: a second, the library's, is short on a busy PC. */

import { configure } from "@testing-library/preact";

configure({ asyncUtilTimeout: 20_000 });
