export { DifferencesScreen } from "./DifferencesScreen";
export { VersionsScreen } from "./VersionsScreen";
