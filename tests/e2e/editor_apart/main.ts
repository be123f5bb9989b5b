// The editor without the page around it, for programs that no hand would build.
import { createEditor } from "../../../ui/src/editor";

Object.assign(window, { createEditor });
