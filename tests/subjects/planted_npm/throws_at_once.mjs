throw new Error('it throws before it is asked')
