// Modules that do what a library should not.
export default ['hangs', 'missing', 'prints', 'right', 'throws', 'throws_at_once', 'unloadable']
